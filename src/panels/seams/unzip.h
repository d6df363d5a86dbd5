#pragma once

#include <cstddef>
#include <vector>

#include "core/thread_pool.h"
#include "panels/seams/seam_chains.h"
#include "panels/seams/seam_state.h"

namespace planish {

/// Opens closed runs of a piece from their ends, from slits and the border, until it and all that
/// comes of it keep a limit of strain by their potential: each time by the step that takes most
/// strain for its length.
/// @param chains of the mesh of the state
/// @param step of the root of the area
/// @return whether the limit is kept; else nothing is left to open
bool unzip(SeamState& state, const std::vector<SeamChain>& chains, std::size_t piece, double limit,
           double step);

}  // namespace planish
