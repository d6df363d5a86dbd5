#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <planish/core/vec.h>

namespace planish {

/// Lines as DXF files have them: places in whole thousandths of a millimetre, without repeats;
/// lines of fewer than two points are left out.
std::vector<std::vector<Vec2>> dxf_places(std::span<const std::vector<Vec2>> lines, bool closed);

/// The number of the loop that encloses most; 0 where there are none.
std::size_t largest_of(std::span<const std::vector<Vec2>> loops);

}  // namespace planish
