#include "unfold/inner_system.h"

namespace planish {

InnerSystem::InnerSystem(const Disk& disk, std::span<const SideWeights> weights) {
  std::vector<Eigen::Triplet<double>> entries, inner_entries;
  std::vector<Index> number(disk.vertex_count, 0);
  for (Index v = 0; v < disk.vertex_count; ++v) {
    number[v] = static_cast<Index>(vertices_.size());
    if (!disk.is_border(v)) vertices_.push_back(v);
  }
  const auto add = [&](Index i, Index j, double value) {
    entries.emplace_back(i, j, value);
    if (!disk.is_border(i) && !disk.is_border(j)) {
      inner_entries.emplace_back(number[i], number[j], value);
    }
  };
  for (std::size_t t = 0; t < disk.triangles.size(); ++t) {
    for (int k = 0; k < 3; ++k) {
      const Index i = disk.triangles[t][(k + 1) % 3], j = disk.triangles[t][(k + 2) % 3];
      const double weight = weights[t][k];
      add(i, i, weight);
      add(j, j, weight);
      add(i, j, -weight);
      add(j, i, -weight);
    }
  }
  const auto n = static_cast<Eigen::Index>(disk.vertex_count);
  full_.resize(n, n);
  full_.setFromTriplets(entries.begin(), entries.end());
  const auto m = static_cast<Eigen::Index>(vertices_.size());
  Eigen::SparseMatrix<double> inner(m, m);
  inner.setFromTriplets(inner_entries.begin(), inner_entries.end());
  solver_.compute(inner);
}

Eigen::VectorXd InnerSystem::solve(const Eigen::VectorXd& border,
                                   const Eigen::VectorXd& source) const {
  Eigen::VectorXd x = border;
  for (const Index v : vertices_)
    x[v] = 0.0;
  if (vertices_.empty()) return x;
  const Eigen::VectorXd from_border = full_ * x;
  Eigen::VectorXd right(static_cast<Eigen::Index>(vertices_.size()));
  for (std::size_t i = 0; i < vertices_.size(); ++i) {
    right[static_cast<Eigen::Index>(i)] = source[vertices_[i]] - from_border[vertices_[i]];
  }
  const Eigen::VectorXd inside = solver_.solve(right);
  for (std::size_t i = 0; i < vertices_.size(); ++i) {
    x[vertices_[i]] = inside[static_cast<Eigen::Index>(i)];
  }
  return x;
}

std::vector<Vec2> InnerSystem::extend(const Disk& disk, std::span<const Vec2> polygon) const {
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(full_.rows());
  Eigen::VectorXd x = zero, y = zero;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    x[disk.border[k]] = polygon[k].x;
    y[disk.border[k]] = polygon[k].y;
  }
  x = solve(x, zero);
  y = solve(y, zero);
  std::vector<Vec2> flat;
  for (Eigen::Index v = 0; v < x.size(); ++v)
    flat.push_back({x[v], y[v]});
  return flat;
}

}  // namespace planish
