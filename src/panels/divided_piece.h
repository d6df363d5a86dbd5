#pragma once

#include <span>
#include <vector>

#include "panels/carried_seams.h"

namespace planish {

/// Divides pieces of a net in two by lines that become edges of it: one whose pattern lies over
/// itself by a shortest way that parts sides which cross (dividing_path()), others by fair lines
/// (dividing_lines()).
/// @param pieces the triangles of each, increasing
CarriedSeams with_pieces_divided(const SeamNet& net, const OpenEdges& open,
                                 std::span<const std::vector<Index>> pieces, double least_area,
                                 ThreadPool& pool);

}  // namespace planish
