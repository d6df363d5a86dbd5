#pragma once

#include <array>
#include <span>
#include <vector>

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include "unfold/disk.h"

namespace planish {

/// The weights of a graph Laplacian at the three sides of a triangle; side k is opposite corner k.
using SideWeights = std::array<double, 3>;

/// A Laplacian over the disk with the border held: solves for the values inside.
class InnerSystem {
 public:
  /// @param weights one per triangle; the weight of an edge is the sum over its triangles
  InnerSystem(const Disk& disk, std::span<const SideWeights> weights);

  bool solvable() const { return solver_.info() == Eigen::Success; }
  std::size_t inner_count() const { return vertices_.size(); }

  /// Values x at all vertices with x = `border` on the border (other entries of it are not looked
  /// at) and (A x)_v = `source`_v inside.
  Eigen::VectorXd solve(const Eigen::VectorXd& border, const Eigen::VectorXd& source) const;
  /// The disk in the plane with its border loop on a polygon, both coordinates harmonic inside.
  std::vector<Vec2> extend(const Disk& disk, std::span<const Vec2> polygon) const;
  /// A x at all vertices.
  Eigen::VectorXd apply(const Eigen::VectorXd& x) const { return full_ * x; }

 private:
  Eigen::SparseMatrix<double> full_;
  // The disk's vertices are in elimination order.
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower, Eigen::NaturalOrdering<int>>
      solver_;
  std::vector<Index> vertices_;  // inner ones, in order
};

}  // namespace planish
