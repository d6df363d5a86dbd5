#pragma once

#include <span>
#include <vector>

#include <planish/draw/color.h>
#include <planish/mesh/patch.h>
#include <planish/mesh/tri_mesh.h>

#include "draw/image.h"

namespace planish {

/// A patch as it was and what became of it, seen alike and coloured by angle defect at one scale;
/// the ground is clear.
struct PatchPictures {
  Image before;
  std::vector<Image> after;  ///< as many as were asked for
  double limit = 0.0;        ///< |defect| at which the colours end, radians
};

/// |defect| at which the colours of a patch end, radians: the 98th percentile of its inner
/// vertices, rounded up.
/// @param defects as from angle_defects()
double defect_limit(std::span<const double> defects, const Connectivity& connectivity);

/// The view is that of view_of() for the patch as it was: its longest extent lies level. The scale
/// ends at the defect_limit() of the patch before. Border vertices, which have no defect, take the
/// mean of their inner neighbours'.
/// @param after the vertices of `before` at other positions
/// @param width of the pictures, pixels
PatchPictures patch_pictures(const Patch& before, std::span<const std::span<const Vec3>> after,
                             ColorMap colors, int width);

}  // namespace planish
