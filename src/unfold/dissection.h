#pragma once

#include <span>
#include <vector>

#include <planish/mesh/connectivity.h>

namespace planish {

/// An order in which to eliminate the used vertices so that sparse factors stay small: the patch is
/// halved by a plane across its longest extent, again and again; each half comes before the
/// vertices that part the two (George 1973). O(n log n).
std::vector<Index> nested_dissection(std::span<const Vec3> positions,
                                     const Connectivity& connectivity);

}  // namespace planish
