#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <planish/mesh/patch.h>

#include "measure/cautions/triangle_hinges.h"

namespace planish {

/// Triangles whose common edges are not bent, and what their outline tells.
struct PlaneFacet {
  static constexpr Index none = static_cast<Index>(-1);

  /// Its outline has more than three corners, or it has vertices inside: it was meant to be plane.
  /// Facets of three corners are also what diagonals leave of a twisted strip.
  bool is_meant = false;
  std::size_t bent_sides = 0;      ///< between corners
  Index apex = none;               ///< where its two bent sides meet; none where there are not two
  std::vector<Index> beyond = {};  ///< the facets across its bent edges, some of them repeatedly
};

struct PlaneFacets {
  std::vector<Index> of_triangle;
  std::vector<PlaneFacet> facets;
};

/// All facets. An edge is bent if it turns by more than 1e-4 rad and 2 % of the largest turn. O(n).
PlaneFacets plane_facets(const Patch& patch, std::span<const TriangleHinges> hinges);

}  // namespace planish
