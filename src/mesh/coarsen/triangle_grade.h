#pragma once

#include <algorithm>

#include "mesh/coarsen/fine_surface.h"

namespace planish {

/// How good some triangles are, by the worst of them.
struct TriangleGrade {
  double cosine = -1.0;     ///< of the smallest angle
  double alignment = 1.0;   ///< cosine of the angle to the fine surface
  bool has_lengths = true;  ///< no edge is of length zero, where nothing could be measured

  void add(const TriangleGrade& other) {
    cosine = std::max(cosine, other.cosine);
    alignment = std::min(alignment, other.alignment);
    has_lengths = has_lengths && other.has_lengths;
  }
};

/// Of the triangle of three vertices of the surface; the worst there is where it has no area.
TriangleGrade grade_of(const FineSurface& surface, Index a, Index b, Index c);

}  // namespace planish
