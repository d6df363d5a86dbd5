#pragma once

#include <vector>

#include <planish/mesh/patch.h>

namespace planish {

/// A place where a dart does good.
struct DartTip {
  Index vertex = 0;
  /// The logarithm of the scale of the conformal map there: below 0 at the tip of a cone or a limb,
  /// above 0 in a saddle.
  double log_scale = 0.0;
};

/// Inner vertices of a disk at which a dart does most good: where the scale of the conformal map
/// that keeps lengths at the border is a local extreme, as cone points are placed by Ben-Chen,
/// Gotsman and Bunin (Conformal flattening by curvature prescription and metric scaling, 2008).
/// The strongest first, each far from those before it, none weaker than a fifth of the first.
/// Of a patch without inner vertices or without curvature, none.
/// @pre the mesh has a border
std::vector<DartTip> dart_tips(const Patch& patch, std::size_t most);

}  // namespace planish
