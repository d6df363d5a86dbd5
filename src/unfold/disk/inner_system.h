#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/SparseCore>

#include "solve/sparse_ldlt.h"
#include "unfold/disk/disk.h"

namespace planish {

/// The weights of a graph Laplacian at the three sides of a triangle; side k is opposite corner k.
using SideWeights = std::array<double, 3>;

/// A Laplacian over the disk with the border held: solves for the values inside.
class InnerSystem {
 public:
  /// @param weights one per triangle; the weight of an edge is the sum over its triangles
  /// @throws Cancelled
  InnerSystem(const Disk& disk, std::span<const SideWeights> weights, ThreadPool& pool);

  bool solvable() const { return solvable_; }
  std::size_t inner_count() const { return vertices_.size(); }

  /// Values x at all vertices, a row each, with x = `border` on the border (other rows of it are
  /// not looked at) and (A x)_v = `source`_v inside. @pre solvable()
  Eigen::MatrixXd solve(const Eigen::MatrixXd& border, const Eigen::MatrixXd& source) const;
  /// The disk in the plane with its border loop on a polygon, both coordinates harmonic inside.
  /// @pre no holes
  std::vector<Vec2> extend(const Disk& disk, std::span<const Vec2> polygon) const;
  /// A x at all vertices.
  Eigen::MatrixXd apply(const Eigen::MatrixXd& x) const {
    return lower_.selfadjointView<Eigen::Lower>() * x;
  }

 private:
  SparseMatrix lower_;
  std::optional<SparseLdlt> solver_;  // none where nothing is inside
  bool solvable_ = true;
  std::vector<Index> vertices_;  // inner ones, in order
};

}  // namespace planish
