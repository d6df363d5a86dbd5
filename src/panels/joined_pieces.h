#pragma once

#include "core/thread_pool.h"
#include "panels/finish.h"

namespace planish {

/// Joins pieces whose patterns are over the limit to larger ones beside them, along a part of the
/// seam between them. In these more is opened first, so that both together keep the limit.
/// @return what is open then
/// @throws Cancelled
OpenEdges with_strained_pieces_joined(const FinishedDivision& division,
                                      const FinishOptions& options, ThreadPool& pool);

}  // namespace planish
