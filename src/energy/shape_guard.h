#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <planish/mesh/tri_mesh.h>

#include "core/thread_pool.h"
#include "energy/summand.h"

namespace planish {

/// Keeps triangles near their form (docs/methods/smooth.md): with s the strain of an edge against
/// the design over 15 %, and a the angles of corners that are sharper than g, 12 degrees or 0.8 of
/// what they were at first,
///
///     G = sum over edges of area share x (s^4 + 0.02 s^2) + sum over corners of 0.01 q^2 + 0.3
///     q^8,
///
/// q = (g - a) / (g - m), m the smallest angle that is allowed, or g / 2 if that is less. Weak
/// where triangles are sound: it only stops them from becoming needles.
class ShapeGuard {
 public:
  /// @param design the positions of the form to stay near to
  /// @param least_angle m, radians
  ShapeGuard(std::vector<Triangle> triangles, const std::vector<Vec3>& design, double least_angle);

  std::size_t edge_count() const { return edges_.size(); }
  const std::array<Index, 2>& edge(std::size_t e) const { return edges_[e].ends; }
  std::size_t corner_count() const { return 3 * triangles_.size(); }
  /// The vertex of the corner, then the others of its triangle.
  std::array<Index, 3> corner(std::size_t c) const {
    const Triangle& t = triangles_[c / 3];
    const std::size_t k = c % 3;
    return {t[k], t[(k + 1) % 3], t[(k + 2) % 3]};
  }
  const std::vector<Triangle>& triangles() const { return triangles_; }

  /// G.
  double value(const std::vector<Vec3>& x, ThreadPool& pool) const;
  /// Of an edge, a function of its length.
  Summand<2> edge_summand(std::size_t e, const std::vector<Vec3>& x) const;
  /// Of a corner, a function of its angle; zero where it is not too sharp.
  Summand<3> corner_summand(std::size_t c, const std::vector<Vec3>& x) const;

 private:
  struct Edge {
    std::array<Index, 2> ends;
    double length, share;  // at first
  };
  struct Bound {
    double sharp;  // g, radians
    double sharp_cosine;
    double range;  // g - m
  };
  static Bound bound_of(double sharp, double least_angle);
  double edge_value(const Edge& edge, const std::vector<Vec3>& x) const;
  double corner_value(std::size_t corner, const std::vector<Vec3>& x) const;

  std::vector<Edge> edges_;
  std::vector<Triangle> triangles_;
  std::vector<Bound> bounds_;  // the first is that of all blunt corners
  // By corner its place in bounds_, k_none where it has no angle.
  std::vector<std::uint32_t> corner_bounds_;
  static constexpr std::uint32_t k_none = ~std::uint32_t{0};
};

}  // namespace planish
