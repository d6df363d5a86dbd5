#pragma once

#include <vector>

#include <planish/core/unit.h>

namespace planish {

/// The longer side of most pieces that are cut, millimetres.
inline constexpr double k_small_piece = 50.0, k_large_piece = 5'000.0;

/// Units other than `unit` under which a piece so many model units long has a usual size, from
/// k_small_piece to k_large_piece; the likeliest first: by how usual the unit and the size are.
std::vector<Unit> likely_units(double longest, Unit unit);

}  // namespace planish
