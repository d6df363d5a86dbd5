#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include <planish/core/vec.h>

#include "geometry/angle_between.h"

namespace planish {

/// The border of a hole that stays a hole in the pattern.
struct HoleBorder {
  std::vector<Index> loop;                ///< the surface on its left
  std::vector<std::vector<Index>> rings;  ///< open, of each vertex of the loop
  std::vector<Index> around;              ///< loop and rings, increasing
};

/// The border of a hole laid out in the plane edge by edge, each corner with its angle on the
/// surface, and what it lacks of closing (docs/methods/smooth.md). What it lacks of the whole turn
/// is spread over its length first, so the gap does not depend on where it begins.
class HoleLayout {
 public:
  /// @param lengths of the edges, each from its vertex of the loop to the next
  /// @param angles by vertex of the loop, sums over the triangles there
  HoleLayout(std::span<const double> lengths, std::span<const double> angles);

  /// (S, J g / size): the turn that it lacks and its gap, a quarter turn to the left.
  std::array<double, 3> defects(double size) const;
  /// How they change with the angle at a vertex of the loop, and with the length of an edge.
  std::array<double, 3> by_angle(std::size_t b, double size) const;
  std::array<double, 3> by_length(std::size_t k, double size) const;

  /// The polygon that the edges make where each takes its share of the gap.
  struct Polygon {
    std::vector<Vec2> places;   ///< p_b / size, from their middle
    std::vector<Vec2> normals;  ///< half of those of the two edges, out of the surface, over size
    double size = 1.0;          ///< rms distance from the middle
  };
  Polygon closed() const;

 private:
  std::size_t next(std::size_t k) const { return k + 1 < edges_.size() ? k + 1 : 0; }

  std::vector<Vec2> edges_, to_end_;  // to_end_: from a vertex to the end of the last edge
  std::vector<double> lengths_, shares_;
  double length_ = 0.0, turn_ = 0.0;
  Vec2 gap_, mean_to_end_;
};

/// @param at the position of a vertex
template <class At>
HoleLayout laid_out(const HoleBorder& hole, const At& at) {
  const std::size_t count = hole.loop.size();
  std::vector<double> lengths, angles;
  for (std::size_t b = 0; b < count; ++b) {
    const Vec3 p = at(hole.loop[b]);
    lengths.push_back(norm(at(hole.loop[b + 1 < count ? b + 1 : 0]) - p));
    angles.push_back(open_angle_sum(p, hole.rings[b], at));
  }
  return {lengths, angles};
}

}  // namespace planish
