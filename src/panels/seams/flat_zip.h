#pragma once

#include <optional>
#include <vector>

#include <planish/core/context.h>

#include "core/thread_pool.h"
#include "panels/piece/laid_flat.h"
#include "panels/seams/seam_chains.h"
#include "panels/seams/seam_state.h"

namespace planish {

/// Of a piece whose pattern lies over itself: the edges of a closed run that divides it, so that
/// sides which cross come to lie in different parts, the one that is shortest for the crossings
/// that it undoes; of a piece without a pattern the shortest. Nothing where there is none.
/// @param piece_price what a piece more costs
/// @param flat its pattern
std::vector<Index> dividing_run(const SeamState& state, const std::vector<SeamChain>& chains,
                                std::size_t piece, double piece_price,
                                const std::optional<LaidFlat>& flat);

/// What zipped_flat() found.
struct FlatState {
  SeamState state;
  bool lies_flat = false;  ///< no piece lies over itself
};

/// Closes seams as Zip does. If a pattern then overlaps itself, opens a run that divides the piece,
/// holds it open, and closes seams again, a few times. If some pattern still overlaps itself,
/// starts anew and joins pieces only where a conformal map of both together does not overlap
/// itself.
/// @param held by edge: 1 for those that stay open
/// @throws Cancelled
FlatState zipped_flat(const SeamState& state, const std::vector<SeamChain>& chains, double limit,
                      const SeamPrices& prices, const std::vector<double>& favour,
                      const OpenEdges& held, ThreadPool& pool);

}  // namespace planish
