#pragma once

#include <span>
#include <vector>

#include <planish/mesh/patch.h>

#include "core/thread_pool.h"
#include "panels/carried_seams.h"

namespace planish {

/// A stretch of the fold, the border of a half on the plane: along the loop of the border from one
/// vertex to another; all of the loop where they are the same.
struct FoldRun {
  Index from, to;
};

/// The seams of a mirrored net on its half alone.
struct FoldedSeams {
  CarriedSeams half;
  std::vector<FoldRun> open;  ///< where the plane is cut
};

FoldedSeams folded_seams(const SeamNet& net, const OpenEdges& open);

/// The seams on a half and its mirror image; all of the plane is a seam.
CarriedSeams unfolded_seams(const FoldedSeams& folded, const Plane& plane);

/// carried_seams() of a mirrored net onto the half of a product.
/// @param half on the side of the plane that the half of the net is on
CarriedSeams carried_mirrored_seams(const Patch& half, const SeamNet& net, const OpenEdges& open,
                                    double least_area, const SeamMoves& moves = {});

/// with_pieces_divided() of a mirrored net: a piece across the plane is opened along it.
CarriedSeams with_mirrored_pieces_divided(const SeamNet& net, const OpenEdges& open,
                                          std::span<const std::vector<Index>> pieces,
                                          double least_area, ThreadPool& pool);

}  // namespace planish
