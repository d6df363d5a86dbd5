#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "measure/form/windows.h"

namespace planish {

/// A design and its result; size_of() the design is 1.
struct Compared {
  const Connectivity& connectivity;
  std::vector<Vec3> before = {}, after = {};
  std::vector<Vec3> normals_before = {}, normals_after = {};  // of length 1
  std::vector<double> areas = {}, offsets = {};               // of the design; along its normals
  // Half of that of each edge at its ends.
  std::vector<double> bending_before = {}, bending_after = {};
  double mean_edge = 0.0;

  /// Radius of a window: the usual one, but at least some mean edges, as a coarse mesh shows no
  /// smaller detail.
  double radius(double usual, double least_edges = 1.5) const {
    return std::max(usual, least_edges * mean_edge);
  }
  /// Calls visit(window) for windows of the design that have enough vertices.
  template <class Visit>
  void for_windows(double radius, const Visit& visit) const {
    constexpr std::size_t least_vertices = 4;
    for_each_window(connectivity, before, areas, radius, [&](const Window& window) {
      if (window.vertices.size() >= least_vertices && window.share > 0.0) visit(window);
    });
  }
};

/// The diagonal of a rectangle that spreads as widely, times unit_scale(): it is the same however
/// the surface is turned.
double size_of(const Patch& design);

/// @pre size > 0
Compared compared(const Patch& design, std::span<const Vec3> after, double size);

/// How much the normals of a window turn across an edge, radians: the spread of their main
/// direction beyond that of the next, which noise has too.
double turn_across(const Compared& pair, const Window& window, std::span<const Vec3> normals);

/// The heights of a window over the plane that fits it, and how much of them the result has.
struct Relief {
  double rms = 0.0;  ///< of the design
  double kept = 1.0;
};
Relief relief_of(const Compared& pair, const Window& window);

/// How far the middle of a window went along the normal beyond the whole, which may shift and tilt.
double dent_of(const Compared& pair, const Window& window, double radius);

/// How unevenly the normals of a window turned, degrees, beyond a part of how they lie.
double uneven_turn_of(const Compared& pair, const Window& window, double radius);

}  // namespace planish
