#pragma once

#include <span>
#include <vector>

#include <planish/mesh/carry.h>
#include <planish/mesh/patch.h>
#include <planish/mesh/surface_line.h>

#include "mesh/geodesic/unfolded_mesh.h"

namespace planish {

/// Lays lines that are drawn near a product on it.
class SeamTracer {
 public:
  /// @param product must outlive it
  explicit SeamTracer(const Patch& product);

  /// The line of each, traced (trace_lines()); empty where that leaves nothing. Where one leaves
  /// the product, as over a hollow, it goes the shortest way on.
  std::vector<SurfaceLine> traced(std::span<const DrawnLine> drawn) const;

  /// A line near another one with its ends, which is nowhere longer and hardly jagged: parts of it
  /// are drawn tight, a few times, in each round other ones. Near sharp vertices it stays.
  /// @param part how long they are, mean edges
  SurfaceLine fair(SurfaceLine line, double part, int rounds) const;

  /// One line of some that follow each other; between them it goes the shortest way.
  SurfaceLine joined(std::span<const SurfaceLine> parts) const;

 private:
  SurfaceLine tight(std::span<const SurfacePoint> part) const;
  bool is_sharp(const SurfacePoint& place) const;

  const Patch& product_;
  UnfoldedMesh unfolded_;
  double mean_edge_;                     // model units
  std::vector<unsigned char> is_sharp_;  // by vertex: seams that left it would leave strain behind
};

}  // namespace planish
