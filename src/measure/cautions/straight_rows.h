#pragma once

#include <planish/mesh/patch.h>

namespace planish {

/// The neighbour of v to which the way from `before`, another one, goes on straightest, as seen
/// along the normal of v: by 60 degrees at most, and straightest on the way back too.
/// @return Edge::none where there is none, and where v has more than 32 neighbours
Index straight_on(const Patch& patch, Index before, Index v);

}  // namespace planish
