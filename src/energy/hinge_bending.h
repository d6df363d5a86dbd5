#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <planish/mesh/patch.h>

#include "core/thread_pool.h"
#include "energy/summand.h"

namespace planish {

/// The bending of a surface from a fraction of the dihedral angles of its design,
///
///     B / B0,  B = sum over inner edges of w (t - kept t0)^2,  w = 3 l^2 / (A1 + A2),
///
/// t the signed angle between the normals of both triangles, l the length of the edge, A the areas
/// (Grinspun and others 2003; docs/fairness.md). The weights w are those of an earlier surface, as
/// set_weights() took them.
class HingeBending {
 public:
  /// @param design with the triangles of the surface, by the same numbers
  /// @param origin the positions that t0 is of
  /// @param b0 above 0
  HingeBending(const Patch& design, const std::vector<Vec3>& origin, double b0);

  std::size_t size() const { return hinges_.size(); }
  /// The ends of an inner edge, then the tips of its triangles.
  const std::array<Index, 4>& stencil(std::size_t hinge) const { return hinges_[hinge]; }

  void set_weights(const std::vector<Vec3>& x, ThreadPool& pool);

  double value(const std::vector<Vec3>& x, ThreadPool& pool, double kept = 0.0) const;
  /// Zero where a triangle has no area.
  Summand<4> summand(std::size_t hinge, const std::vector<Vec3>& x, double kept = 0.0) const;

 private:
  std::vector<std::array<Index, 4>> hinges_;
  std::vector<double> first_angles_, weights_;
  double b0_;
};

}  // namespace planish
