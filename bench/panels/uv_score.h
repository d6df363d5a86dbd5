#pragma once

#include <cstddef>

#include <planish/measure/limit_check.h>

#include "panels/uv_map.h"

namespace planish {

/// Measures of a texture map, of any program: of its cuts and its distortion.
struct UvScore {
  std::size_t pieces = 0;       ///< parts that hang together in the plane
  std::size_t tips = 0;         ///< ends of slits inside a piece
  double seam = 0.0;            ///< length of the cuts, each once, over the root of the area
  double jag = 1.0;             ///< that length over the length of its chords (jag_of())
  EdgeStrain strain = {};       ///< of the whole, scaled so that the areas are equal
  std::size_t overlapping = 0;  ///< pieces with a border that crosses itself (overlap_of())
  std::size_t flipped = 0;      ///< triangles that are turned over against their piece
};

/// Cuts are the edges inside the surface at which the corners of the two triangles lie elsewhere.
/// @throws Error what stands in the way of Purpose::measure
UvScore score_of(const UvMap& map);

}  // namespace planish
