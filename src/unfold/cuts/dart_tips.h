#pragma once

#include <vector>

#include <planish/mesh/patch.h>

namespace planish {

/// Inner vertices of a disk at which a dart does most good: where the scale of the conformal map
/// that keeps lengths at the border is a local extreme, as cone points are placed by Ben-Chen,
/// Gotsman and Bunin (Conformal flattening by curvature prescription and metric scaling, 2008).
/// The strongest first, each far from those before it, none weaker than a fifth of the first.
/// Of a patch without inner vertices or without curvature, none.
/// @pre the mesh is a disk
std::vector<Index> dart_tips(const Patch& patch, std::size_t most);

}  // namespace planish
