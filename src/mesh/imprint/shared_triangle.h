#pragma once

#include <optional>
#include <span>
#include <vector>

#include <planish/mesh/patch.h>
#include <planish/mesh/surface_line.h>

namespace planish {

/// The vertices whose triangles all hold a point.
std::vector<Index> carriers_of(const SurfacePoint& point);

/// A triangle that has all of these vertices, which begins with the first of them.
std::optional<Triangle> triangle_with(const Patch& patch, std::span<const Index> vertices);

/// A triangle that holds both points.
std::optional<Triangle> shared_triangle(const Patch& patch, const SurfacePoint& a,
                                        const SurfacePoint& b);

/// The place on the straight way from one point to another on one triangle, a share of it along.
std::optional<SurfacePoint> point_between(const Patch& patch, const SurfacePoint& a,
                                          const SurfacePoint& b, double share);

}  // namespace planish
