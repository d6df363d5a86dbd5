#include "unfold/disk/inner_system.h"

#include <algorithm>

#include "solve/sparse_pattern.h"

namespace planish {

namespace {

constexpr int k_border = -1;

}  // namespace

InnerSystem::InnerSystem(const Disk& disk, std::span<const SideWeights> weights, ThreadPool& pool) {
  lower_ = sparse_matrix(disk.vertex_count, disk.vertex_count, [&](const auto& add) {
    for (std::size_t t = 0; t < disk.triangles.size(); ++t) {
      for (int k = 0; k < 3; ++k) {
        const Index i = disk.triangles[t][(k + 1) % 3], j = disk.triangles[t][(k + 2) % 3];
        const double weight = weights[t][k];
        add(i, i, weight);
        add(j, j, weight);
        add(std::max(i, j), std::min(i, j), -weight);
      }
    }
  });

  std::vector<int> number(disk.vertex_count, k_border);
  for (Index v = 0; v < disk.vertex_count; ++v) {
    if (disk.is_border(v)) continue;
    number[v] = static_cast<int>(vertices_.size());
    vertices_.push_back(v);
  }
  if (vertices_.empty()) return;
  const auto m = static_cast<Eigen::Index>(vertices_.size());
  SparseMatrix inner(m, m);
  inner.reserve(lower_.nonZeros());
  for (const Index v : vertices_) {
    inner.startVec(number[v]);
    for (SparseMatrix::InnerIterator entry(lower_, v); entry; ++entry) {
      const int row = number[entry.row()];
      if (row != k_border) inner.insertBack(row, number[v]) = entry.value();
    }
  }
  inner.finalize();
  solver_.emplace(inner, &pool);  // the disk's vertices are in order of elimination
  solvable_ = solver_->factor(inner, pool);
}

Eigen::MatrixXd InnerSystem::solve(const Eigen::MatrixXd& border,
                                   const Eigen::MatrixXd& source) const {
  Eigen::MatrixXd x = border;
  for (const Index v : vertices_)
    x.row(v).setZero();
  if (vertices_.empty()) return x;
  Eigen::MatrixXd right = source - apply(x);
  for (std::size_t i = 0; i < vertices_.size(); ++i)
    right.row(static_cast<Eigen::Index>(i)) = right.row(vertices_[i]);
  right.conservativeResize(static_cast<Eigen::Index>(vertices_.size()), Eigen::NoChange);
  const Eigen::MatrixXd inside = solver_->solve(right);
  for (std::size_t i = 0; i < vertices_.size(); ++i)
    x.row(vertices_[i]) = inside.row(static_cast<Eigen::Index>(i));
  return x;
}

std::vector<Vec2> InnerSystem::extend(const Disk& disk, std::span<const Vec2> polygon) const {
  const Eigen::MatrixXd zero = Eigen::MatrixXd::Zero(lower_.rows(), 2);
  Eigen::MatrixXd positions = zero;
  for (std::size_t k = 0; k < polygon.size(); ++k)
    positions.row(disk.border[k]) << polygon[k].x, polygon[k].y;
  positions = solve(positions, zero);
  std::vector<Vec2> flat;
  for (Eigen::Index v = 0; v < positions.rows(); ++v)
    flat.push_back({positions(v, 0), positions(v, 1)});
  return flat;
}

}  // namespace planish
