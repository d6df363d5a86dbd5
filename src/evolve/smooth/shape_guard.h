#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "core/thread_pool.h"
#include "evolve/state/patch_state.h"

namespace planish {

/// Keeps triangles near their form: with s the strain of an edge against the design over 15 %, and
/// a the angles of corners that are sharper than g, 12 degrees or 0.8 of what they were at first,
///
///     G = sum over edges of area share x (s^4 + 0.02 s^2) + sum over corners of 0.01 q^2 + 0.3
///     q^8,
///
/// q = (g - a) / (g - m), m the smallest angle that is allowed, or g / 2 if that is less. Weak
/// where triangles are sound: it only stops them from becoming needles.
class ShapeGuard {
 public:
  /// Takes the form from the state's origins.
  /// @param least_angle m, radians
  /// @param state must outlive it
  ShapeGuard(const PatchState& state, double least_angle);

  std::size_t edge_count() const { return edges_.size(); }
  const std::array<Index, 2>& edge(std::size_t e) const { return edges_[e].ends; }
  std::size_t corner_count() const { return corners_.size(); }
  /// The vertex of the corner, then the others of its triangle.
  const std::array<Index, 3>& corner(std::size_t c) const { return corners_[c].vertices; }

  /// G of the patch as it is now.
  double value(ThreadPool& pool) const;

  /// First derivative of a term by what it is a function of, and the second, at least 0.
  template <std::size_t n>
  struct Slope {
    double first = 0.0, second = 0.0;
    std::array<Vec3, n> gradient = {};  ///< of the edge's length, or the corner's angle
  };
  Slope<2> edge_slope(std::size_t e) const;
  /// Zero where the corner is not too sharp.
  Slope<3> corner_slope(std::size_t c) const;

 private:
  struct Edge {
    std::array<Index, 2> ends;
    double length, share;  // at first
  };
  struct Corner {
    std::array<Index, 3> vertices;
    double sharp;  // g, radians
    double sharp_cosine;
    double range;  // g - m
  };
  double edge_value(const Edge& edge) const;
  double corner_value(const Corner& corner) const;

  const PatchState& state_;
  std::vector<Edge> edges_;
  std::vector<Corner> corners_;
};

}  // namespace planish
