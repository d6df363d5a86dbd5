#pragma once

#include <span>
#include <vector>

#include "panels/carried_seams.h"

namespace planish {

/// Divides pieces of a net in two by fair lines (dividing_lines()), which become edges of it.
/// @param pieces the triangles of each, increasing
CarriedSeams with_pieces_divided(const SeamNet& net, const OpenEdges& open,
                                 std::span<const std::vector<Index>> pieces, double least_area,
                                 ThreadPool& pool);

}  // namespace planish
