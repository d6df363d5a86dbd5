#include "unfold/stretch/stretch_system.h"

#include <algorithm>

#include "solve/sparse_pattern.h"

namespace planish {

StretchSystem::StretchSystem(const Disk& disk, ThreadPool& pool) : StretchSystem(disk, 0, pool) {
  make_pattern();
  find_slots();
}

StretchSystem::StretchSystem(const Disk& disk, std::size_t more_rows, ThreadPool& pool)
    : disk_(disk), pool_(pool), unknowns_(disk) {
  const Eigen::Index rows = unknowns_.count() + static_cast<Eigen::Index>(more_rows);
  hessian_.resize(rows, rows);
  gradient_.resize(rows);
}

void StretchSystem::find_slots() {
  for (const Triangle& t : disk_.triangles)
    for_pairs(t, [&](int row, int column, int, int) {
      slots_.push_back(entry_of(hessian_, row, column));
    });
}

void StretchSystem::assemble(const std::vector<Vec2>& flat, Curvature curvature) {
  std::fill_n(hessian_.valuePtr(), hessian_.nonZeros(), 0.0);
  gradient_.setZero();
  auto next_slot = slots_.begin();
  for (std::size_t t = 0; t < disk_.triangles.size(); ++t) {
    const TriangleEnergy energy = energy_of(disk_, t, flat);
    const Triangle& tri = disk_.triangles[t];
    add_gradient(tri, energy.gradient());
    const Hessian6 hessian = hessian_of(t, energy, flat, curvature);
    for_pairs(tri, [&](int, int, int i, int j) {
      hessian_.valuePtr()[*next_slot++] +=
          hessian[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
    });
  }
}

void StretchSystem::add_gradient(const Triangle& corners, const std::array<double, 6>& gradient) {
  for (int i = 0; i < 6; ++i) {
    const int row = unknowns_.column(corners[i / 2], i % 2);
    if (row != Unknowns::k_fixed) gradient_[row] += gradient[static_cast<std::size_t>(i)];
  }
}

bool StretchSystem::factor() {
  if (!factor_) {
    const std::vector<Index> order = elimination_order();
    if (order.empty())
      factor_.emplace(hessian_, &pool_);
    else
      factor_.emplace(hessian_, order, &pool_);
  }
  return factor_->factor(hessian_, pool_);
}

StretchSystem::EdgeSlots StretchSystem::slots_of(const FlatEdge& edge) const {
  EdgeSlots slots{};
  auto slot = slots.begin();
  for_pairs(edge, [&](int row, int column, int, int) {
    *slot++ = static_cast<std::uint32_t>(entry_of(hessian_, row, column));
  });
  return slots;
}

void StretchSystem::add(const FlatEdge& edge, const EdgeSlots& slots, Vec2 gradient,
                        const EdgeHessian& hessian) {
  add_to(gradient_, edge, gradient);
  const double block[2][2] = {{hessian.xx, hessian.xy}, {hessian.xy, hessian.yy}};
  auto slot = slots.begin();
  for_pairs(edge, [&](int, int, int i, int j) {
    const double value = block[i % 2][j % 2];
    hessian_.valuePtr()[*slot++] += i / 2 == j / 2 ? value : -value;
  });
}

bool StretchSystem::solved_by(const Eigen::VectorXd& step) const {
  const Eigen::VectorXd residual = hessian_.selfadjointView<Eigen::Lower>() * step + gradient_;
  return residual.norm() <= 0.1 * gradient_.norm();
}

void StretchSystem::add_to(Eigen::VectorXd& unknowns, const FlatEdge& edge, Vec2 gradient) const {
  const auto add = [&](Index v, int axis, double value) {
    const int row = unknowns_.column(v, axis);
    if (row != Unknowns::k_fixed) unknowns[row] += value;
  };
  add(edge.from, 0, -gradient.x);
  add(edge.from, 1, -gradient.y);
  add(edge.to, 0, gradient.x);
  add(edge.to, 1, gradient.y);
}

std::vector<Vec2> StretchSystem::spread(const Eigen::VectorXd& unknowns) const {
  std::vector<Vec2> at(disk_.vertex_count);
  for (Index v = 0; v < disk_.vertex_count; ++v) {
    const int x = unknowns_.column(v, 0), y = unknowns_.column(v, 1);
    at[v] = {x == Unknowns::k_fixed ? 0.0 : unknowns[x],
             y == Unknowns::k_fixed ? 0.0 : unknowns[y]};
  }
  return at;
}

/// Two unknowns meet where their vertices share a triangle.
void StretchSystem::make_pattern() {
  std::vector<Eigen::Triplet<char>> pairs;
  for (const Triangle& t : disk_.triangles) {
    for (int k = 0; k < 3; ++k) {
      pairs.emplace_back(t[k], t[k], 1);
      pairs.emplace_back(std::max(t[k], t[(k + 1) % 3]), std::min(t[k], t[(k + 1) % 3]), 1);
    }
  }
  const auto n = static_cast<Eigen::Index>(disk_.vertex_count);
  Eigen::SparseMatrix<char> meet(n, n);
  meet.setFromTriplets(pairs.begin(), pairs.end(), [](char a, char) { return a; });
  hessian_.reserve(4 * meet.nonZeros());
  for (Index v = 0; v < disk_.vertex_count; ++v) {
    for (const int column : {unknowns_.column(v, 0), unknowns_.column(v, 1)}) {
      if (column == Unknowns::k_fixed) continue;
      hessian_.startVec(column);
      for (Eigen::SparseMatrix<char>::InnerIterator w(meet, v); w; ++w) {
        for (const int axis : {0, 1}) {
          const int row = unknowns_.column(static_cast<Index>(w.row()), axis);
          if (row >= column) hessian_.insertBack(row, column) = 0.0;
        }
      }
    }
  }
  hessian_.finalize();
}

template <class Visit>
void StretchSystem::for_pairs(const FlatEdge& edge, Visit visit) const {
  const Index ends[2] = {edge.from, edge.to};
  for (int i = 0; i < 4; ++i) {
    const int row = unknowns_.column(ends[i / 2], i % 2);
    for (int j = 0; j < 4; ++j) {
      const int column = unknowns_.column(ends[j / 2], j % 2);
      if (column != Unknowns::k_fixed && row >= column) visit(row, column, i, j);
    }
  }
}

}  // namespace planish
