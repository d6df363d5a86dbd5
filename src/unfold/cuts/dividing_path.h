#pragma once

#include <optional>
#include <span>
#include <vector>

#include <planish/mesh/patch.h>

namespace planish {

/// A path of edges from border to border that divides a patch where it is narrow, so that sides of
/// the outline that cross each other in its pattern come to lie in different pieces: the one that
/// is shortest for the outline that it takes off and for the crossings that it undoes, of the
/// shortest paths from a few dozen places. Nothing where there is none.
/// @param pattern a place for each vertex; empty: there is none, and any path will do
/// @param weights as InsidePaths takes them
std::optional<std::vector<Index>> dividing_path(const Patch& patch, std::span<const Vec2> pattern,
                                                std::span<const double> weights);

}  // namespace planish
