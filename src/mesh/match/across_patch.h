#pragma once

#include "mesh/match/border_lines.h"

namespace planish {

/// Whether a vertex of the border is just across the patch from an edge of its border, so that a
/// thin strip of the patch divides them: walks from the edge at right angles over the patch.
/// @param share of the edge, from where to walk
/// @param distance of the vertex from there, model units, above 0
bool is_just_across(const Patch& patch, const BorderEdge& edge, double share, Vec3 vertex,
                    double distance);

}  // namespace planish
