#include "unfold/stretch/stretch_system.h"

namespace planish {

namespace {

/// Turning and shifting cost no energy, so the first border vertex stays, and the one half way
/// around keeps its y; see turn_to_axis().
std::vector<unsigned char> block_sizes(const Disk& disk, std::size_t more_blocks) {
  std::vector<unsigned char> sizes(disk.vertex_count, 2);
  sizes[disk.border.front()] = 0;
  sizes[opposite_of_first(disk)] = 1;
  sizes.resize(sizes.size() + more_blocks, 1);
  return sizes;
}

BlockMatrix matrix_of(const Disk& disk, std::size_t more_blocks,
                      const BlockMatrix::ForPairs& more_pairs) {
  return {block_sizes(disk, more_blocks), [&](const BlockMatrix::VisitPair& visit) {
            for (const Triangle& t : disk.triangles) {
              for (std::size_t k = 0; k < 3; ++k)
                visit(t[k], t[(k + 1) % 3]);
            }
            more_pairs(visit);
          }};
}

double axis_of(Vec2 a, int axis) {
  return axis == 0 ? a.x : a.y;
}

}  // namespace

StretchSystem::StretchSystem(const Disk& disk, ThreadPool& pool)
    : StretchSystem(
          disk, 0, [](const BlockMatrix::VisitPair&) {}, pool) {}

StretchSystem::StretchSystem(const Disk& disk, std::size_t more_blocks,
                             const BlockMatrix::ForPairs& more_pairs, ThreadPool& pool)
    : disk_(disk), pool_(pool), matrix_(matrix_of(disk, more_blocks, more_pairs)) {
  gradient_.resize(matrix_.lower().rows());
  triangle_pairs_.reserve(disk.triangles.size());
  for (const Triangle& t : disk.triangles)
    triangle_pairs_.push_back(pairs_of(t));
}

StretchSystem::TrianglePairs StretchSystem::pairs_of(const Triangle& corners) const {
  return {matrix_.pair_of(corners[0], corners[1]), matrix_.pair_of(corners[0], corners[2]),
          matrix_.pair_of(corners[1], corners[2])};
}

void StretchSystem::assemble(const std::vector<Vec2>& flat, Curvature curvature) {
  matrix_.clear();
  gradient_.setZero();
  for (std::size_t t = 0; t < disk_.triangles.size(); ++t) {
    const Triangle& tri = disk_.triangles[t];
    const TriangleEnergy energy(disk_.rest[t], flat[tri[0]], flat[tri[1]], flat[tri[2]]);
    const std::array<double, 6> gradient = energy.gradient();
    for (std::size_t k = 0; k < 3; ++k)
      add_to(gradient_, tri[k], {gradient[2 * k], gradient[2 * k + 1]});
    const Hessian6 hessian = hessian_of(t, energy, flat, curvature);
    matrix_.add(tri, triangle_pairs_[t].data(),
                [&](std::size_t i, int row, std::size_t j, int column) {
                  return hessian[2 * i + static_cast<std::size_t>(row)]
                                [2 * j + static_cast<std::size_t>(column)];
                });
  }
}

void StretchSystem::add(const Summand<3, Vec2>& part, const TrianglePairs& pairs) {
  for (std::size_t k = 0; k < 3; ++k)
    add_to(gradient_, part.vertices[k], part.first * part.gradient[k]);
  matrix_.add(part.vertices, pairs.data(), [&](std::size_t i, int row, std::size_t j, int column) {
    return part.second * axis_of(part.gradient[i], row) * axis_of(part.gradient[j], column);
  });
}

bool StretchSystem::factor() {
  if (!factor_) {
    const std::vector<Index> order = elimination_order();
    if (order.empty())
      factor_.emplace(hessian(), &pool_);
    else
      factor_.emplace(hessian(), order, &pool_);
  }
  return factor_->factor(hessian(), pool_);
}

void StretchSystem::add(const FlatEdge& edge, BlockMatrix::Pair ends, const EdgeTerm& term) {
  add_to(gradient_, edge, term.gradient);
  matrix_.add(std::array{edge.from, edge.to}, &ends,
              [&](std::size_t i, int row, std::size_t j, int column) {
                const double diagonal = row == 0 ? term.xx : term.yy;
                const double entry = row == column ? diagonal : term.xy;
                return i == j ? entry : -entry;
              });
}

bool StretchSystem::solved_by(const Eigen::VectorXd& step) const {
  const Eigen::VectorXd residual = hessian().selfadjointView<Eigen::Lower>() * step + gradient_;
  return residual.norm() <= 0.1 * gradient_.norm();
}

void StretchSystem::add_to(Eigen::VectorXd& unknowns, Index v, Vec2 gradient) const {
  for (int axis = 0; axis < matrix_.size(v); ++axis)
    unknowns[matrix_.unknown(v, axis)] += axis_of(gradient, axis);
}

void StretchSystem::add_to(Eigen::VectorXd& unknowns, const FlatEdge& edge, Vec2 gradient) const {
  add_to(unknowns, edge.from, {-gradient.x, -gradient.y});
  add_to(unknowns, edge.to, gradient);
}

std::vector<Vec2> StretchSystem::spread(const Eigen::VectorXd& unknowns) const {
  std::vector<Vec2> at(disk_.vertex_count);
  for (Index v = 0; v < disk_.vertex_count; ++v) {
    if (matrix_.size(v) > 0) at[v].x = unknowns[matrix_.unknown(v, 0)];
    if (matrix_.size(v) > 1) at[v].y = unknowns[matrix_.unknown(v, 1)];
  }
  return at;
}

}  // namespace planish
