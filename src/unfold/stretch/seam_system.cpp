#include "unfold/stretch/seam_system.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Eigenvalues>

#include "solve/sparse_pattern.h"

namespace planish {

namespace {

/// In units of lengths by pulls, both of which are near 1 for the whole disk.
constexpr double k_give = 1e-10;

struct BorderEdge {
  Index from, to;
};

BorderEdge border_edge(const Disk& disk, std::size_t k) {
  return {disk.border[k], disk.border[(k + 1) % disk.border.size()]};
}

}  // namespace

SeamSystem::SeamSystem(const Disk& disk, const BorderLengths& lengths, const BorderBend& bend,
                       ThreadPool& pool)
    : disk_(disk),
      pool_(pool),
      lengths_(lengths),
      bend_(bend),
      unknowns_(disk),
      column_(2 * disk.vertex_count, Unknowns::k_fixed),
      pull_column_(disk.border.size(), 0),
      edges_of_(disk.triangles.size()) {
  number_unknowns();
  make_pattern();
  pulls_ = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(disk.border.size()));
  const auto add_slot = [&](int row, int column, int, int) {
    slots_.push_back(entry_of(lower_, row, column));
  };
  for (const Triangle& t : disk.triangles)
    for_pairs(t, add_slot);
  for (const BorderBend::Turn& turn : bend.turns())
    for_pairs(turn.vertices, add_slot);
}

void SeamSystem::number_unknowns() {
  std::vector<std::vector<std::size_t>> closes(disk_.vertex_count);  // edges, at their later end
  std::vector<std::size_t> edge_from(disk_.vertex_count, disk_.border.size());
  for (std::size_t k = 0; k < disk_.border.size(); ++k) {
    const BorderEdge edge = border_edge(disk_, k);
    closes[std::max(edge.from, edge.to)].push_back(k);
    edge_from[edge.from] = k;
  }
  int count = 0;
  for (Index v = 0; v < disk_.vertex_count; ++v) {
    for (const int axis : {0, 1}) {
      if (unknowns_.column(v, axis) != Unknowns::k_fixed) column_[2 * v + axis] = count++;
    }
    for (const std::size_t k : closes[v])
      pull_column_[k] = count++;
  }
  lower_.resize(count, count);
  gradient_.resize(count);
  for (std::size_t t = 0; t < disk_.triangles.size(); ++t) {
    for (int i = 0; i < 3; ++i) {
      const std::size_t k = edge_from[disk_.triangles[t][i]];
      if (k == disk_.border.size()) continue;
      if (border_edge(disk_, k).to == disk_.triangles[t][(i + 1) % 3]) {
        edges_of_[t].push_back(static_cast<Index>(k));
      }
    }
  }
}

template <class Visit>
void SeamSystem::for_pairs(const Triangle& tri, Visit visit) const {
  for (int i = 0; i < 6; ++i) {
    const int row = column_[2 * tri[i / 2] + i % 2];
    for (int j = 0; j < 6; ++j) {
      const int column = column_[2 * tri[j / 2] + j % 2];
      if (column != Unknowns::k_fixed && row >= column) visit(row, column, i, j);
    }
  }
}

void SeamSystem::make_pattern() {
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(21 * (disk_.triangles.size() + bend_.turns().size()) + 5 * disk_.border.size());
  const auto add = [&](int row, int column, int, int) { entries.emplace_back(row, column, 0.0); };
  for (const Triangle& t : disk_.triangles)
    for_pairs(t, add);
  for (const BorderBend::Turn& turn : bend_.turns())
    for_pairs(turn.vertices, add);
  for (std::size_t k = 0; k < disk_.border.size(); ++k) {
    const BorderEdge edge = border_edge(disk_, k);
    const int pull = pull_column_[k];
    entries.emplace_back(pull, pull, 0.0);
    for (const Index v : {edge.from, edge.to}) {
      for (const int axis : {0, 1}) {
        const int column = column_[2 * v + axis];
        if (column == Unknowns::k_fixed) continue;
        entries.emplace_back(std::max(pull, column), std::min(pull, column), 0.0);
      }
    }
  }
  lower_.setFromTriplets(entries.begin(), entries.end());
}

Eigen::VectorXd SeamSystem::gaps(const std::vector<Vec2>& flat) const {
  Eigen::VectorXd gaps = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(disk_.border.size()));
  for (std::size_t k = 0; k < disk_.border.size(); ++k) {
    if (lengths_.may_change(k)) continue;
    const BorderEdge edge = border_edge(disk_, k);
    gaps[static_cast<Eigen::Index>(k)] =
        norm(flat[edge.to] - flat[edge.from]) - lengths_.of_edges[k];
  }
  return gaps;
}

/// Of a triangle with border edges the pulls' share is added, and what is left of negative
/// curvature then is cut off: less is, than of each by itself.
SeamSystem::Matrix6 SeamSystem::hessian_of(std::size_t t, const std::vector<Vec2>& flat,
                                           const Eigen::VectorXd& pulls,
                                           Curvature curvature) const {
  const bool on_border = !edges_of_[t].empty();
  const auto own = energy_of(disk_, t, flat).hessian(on_border ? Curvature::full : curvature);
  Matrix6 hessian;
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j < 6; ++j)
      hessian(i, j) = own[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
  }
  if (!on_border) return hessian;
  const Triangle& tri = disk_.triangles[t];
  for (const Index k : edges_of_[t]) {
    const BorderEdge edge = border_edge(disk_, k);
    const Vec2 d = flat[edge.to] - flat[edge.from];
    const double length = norm(d);
    Eigen::Matrix<double, 6, 1> across = Eigen::Matrix<double, 6, 1>::Zero();
    for (int corner = 0; corner < 3; ++corner) {
      const double sign = tri[corner] == edge.to ? 1.0 : tri[corner] == edge.from ? -1.0 : 0.0;
      across[2 * corner] = -sign * d.y / length;
      across[2 * corner + 1] = sign * d.x / length;
    }
    hessian += (pulls[static_cast<Eigen::Index>(k)] / length) * across * across.transpose();
  }
  if (curvature == Curvature::full) return hessian;
  const Eigen::SelfAdjointEigenSolver<Matrix6> eigen(hessian);
  return eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(0.0).asDiagonal() *
         eigen.eigenvectors().transpose();
}

void SeamSystem::add_lengths(const std::vector<Vec2>& flat) {
  double* values = lower_.valuePtr();
  for (std::size_t k = 0; k < disk_.border.size(); ++k) {
    const BorderEdge edge = border_edge(disk_, k);
    const int pull = pull_column_[k];
    values[entry_of(lower_, pull, pull)] = lengths_.may_change(k) ? -1.0 : -k_give;
    if (lengths_.may_change(k)) continue;
    const Vec2 d = flat[edge.to] - flat[edge.from];
    const Vec2 along = (1.0 / norm(d)) * d;
    const auto set = [&](Index v, double sign) {
      const int x = column_[2 * v], y = column_[2 * v + 1];
      if (x != Unknowns::k_fixed) values[entry_of(lower_, pull, x)] = sign * along.x;
      if (y != Unknowns::k_fixed) values[entry_of(lower_, pull, y)] = sign * along.y;
    };
    set(edge.from, -1.0);
    set(edge.to, 1.0);
  }
}

void SeamSystem::add_gradient(const Triangle& corners, const std::array<double, 6>& gradient) {
  for (int i = 0; i < 6; ++i) {
    const int row = column_[2 * corners[i / 2] + i % 2];
    if (row != Unknowns::k_fixed) gradient_[row] += gradient[static_cast<std::size_t>(i)];
  }
}

bool SeamSystem::factor(const std::vector<Vec2>& flat, const Eigen::VectorXd& pulls,
                        Curvature curvature) {
  std::fill_n(lower_.valuePtr(), lower_.nonZeros(), 0.0);
  gradient_.setZero();
  pulls_ = pulls;
  auto next_slot = slots_.begin();
  for (std::size_t t = 0; t < disk_.triangles.size(); ++t) {
    const Triangle& tri = disk_.triangles[t];
    add_gradient(tri, energy_of(disk_, t, flat).gradient());
    const Matrix6 hessian = hessian_of(t, flat, pulls, curvature);
    for_pairs(tri,
              [&](int, int, int i, int j) { lower_.valuePtr()[*next_slot++] += hessian(i, j); });
  }
  for (const BorderBend::Turn& turn : bend_.turns()) {
    const BorderBend::Derivatives bend = BorderBend::derivatives(turn, flat);
    add_gradient(turn.vertices, bend.gradient);
    for_pairs(turn.vertices, [&](int, int, int i, int j) {
      lower_.valuePtr()[*next_slot++] +=
          bend.hessian[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
    });
  }
  add_lengths(flat);
  if (!solver_) solver_.emplace(lower_);  // unknowns are in order of elimination
  return solver_->factor(lower_, pool_) && solver_->negative_pivots() == disk_.border.size();
}

std::vector<Vec2> SeamSystem::spread(const Eigen::VectorXd& solution) const {
  std::vector<Vec2> move(disk_.vertex_count);
  for (std::size_t v = 0; v < move.size(); ++v) {
    const int x = column_[2 * v], y = column_[2 * v + 1];
    move[v] = {x == Unknowns::k_fixed ? 0.0 : solution[x],
               y == Unknowns::k_fixed ? 0.0 : solution[y]};
  }
  return move;
}

SeamSystem::Step SeamSystem::step(const Eigen::VectorXd& gaps) const {
  Eigen::VectorXd right = -gradient_;
  for (std::size_t k = 0; k < pull_column_.size(); ++k) {
    const auto i = static_cast<Eigen::Index>(k);
    right[pull_column_[k]] = -gaps[i] - k_give * pulls_[i];
  }
  const auto matrix = lower_.selfadjointView<Eigen::Lower>();
  Eigen::VectorXd solution = solver_->solve(right, pool_);
  const Eigen::VectorXd rest = right - matrix * solution;
  solution += solver_->solve(rest, pool_);
  Step step;
  step.sound = (right - matrix * solution).norm() <= 1e-3 * right.norm();
  step.move = spread(solution);
  step.pulls.resize(gaps.size());
  for (std::size_t k = 0; k < pull_column_.size(); ++k) {
    step.pulls[static_cast<Eigen::Index>(k)] = solution[pull_column_[k]];
    solution[pull_column_[k]] = 0.0;
  }
  step.slope = gradient_.dot(solution);
  return step;
}

std::vector<Vec2> SeamSystem::correction(const Eigen::VectorXd& change) const {
  Eigen::VectorXd right = Eigen::VectorXd::Zero(lower_.rows());
  for (std::size_t k = 0; k < pull_column_.size(); ++k)
    right[pull_column_[k]] = change[static_cast<Eigen::Index>(k)];
  return spread(solver_->solve(right, pool_));
}

}  // namespace planish
