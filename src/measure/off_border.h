#pragma once

#include <algorithm>

#include <planish/mesh/patch.h>

namespace planish {

/// Whether a vertex is inside and none of its neighbours is on the border, which smoothing does not
/// move.
inline bool is_off_border(const Connectivity& connectivity, Index v) {
  const auto ring = connectivity.ring(v);
  return connectivity.is_inner(v) &&
         std::none_of(ring.begin(), ring.end(), [&](Index w) { return connectivity.is_border(w); });
}

}  // namespace planish
