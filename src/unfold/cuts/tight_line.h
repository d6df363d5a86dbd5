#pragma once

#include <span>

#include <planish/core/context.h>
#include <planish/mesh/surface_line.h>

namespace planish {

/// A path of edges drawn tight over the surface, its ends held; a loop (its last vertex is its
/// first one) may move as a whole. With weights, parts of it stay where tight they would count for
/// more.
/// @param weights of vertices, by which lengths near them count; empty: 1 everywhere
SurfaceLine tight_line(const Patch& patch, std::span<const Index> path,
                       std::span<const double> weights, const Context& context);

}  // namespace planish
