#pragma once

#include <optional>
#include <vector>

#include <planish/mesh/patch.h>
#include <planish/mesh/surface_line.h>

namespace planish {

/// The vertices whose triangles all hold a point.
std::vector<Index> carriers_of(const SurfacePoint& point);

/// A triangle that holds both points.
std::optional<Triangle> common_triangle(const Patch& patch, const SurfacePoint& a,
                                        const SurfacePoint& b);

/// The point between two that lie on one triangle; nothing where they do not.
/// @param share of the way from a to b
std::optional<SurfacePoint> point_between(const Patch& patch, const SurfacePoint& a,
                                          const SurfacePoint& b, double share);

}  // namespace planish
