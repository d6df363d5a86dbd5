#pragma once

#include <string>

#include <planish/mesh/surface_line.h>

namespace planish {

/// A plane in words, in model units: "x=0", or "the plane with normal (0.995, 0.08, 0.05), offset
/// 1.37". That of an axis is as people give one.
/// @param plane its normal has length 1
std::string plane_text(const Plane& plane);

}  // namespace planish
