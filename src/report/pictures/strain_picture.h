#pragma once

#include <span>
#include <vector>

#include <planish/mesh/tri_mesh.h>
#include <planish/unfold/unfold.h>

#include "draw/image.h"

namespace planish {

/// A pattern and the patch that it is of: positions of the same mesh.
struct PatternOfPatch {
  std::span<const Vec3> patch;
  const Pattern& pattern;
};

/// Draws patterns of one mesh at one size per length, coloured by strain at one scale, the colour
/// of a vertex that of the mean of its triangles; the ground is clear. As pixels, so that a page
/// with many patterns of a dense mesh stays small.
/// @param limit |strain| at which the colours end
/// @param width of the pictures, pixels
std::vector<Image> strain_pictures(const TriMesh& mesh, std::span<const PatternOfPatch> patterns,
                                   double limit, int width);

}  // namespace planish
