#pragma once

#include <cstdint>
#include <span>

#include <planish/core/vec.h>

namespace planish {

/// Tells patterns apart: FNV-1a of 64 bits over the coordinates in order, x before y, each in whole
/// thousandths of a millimetre as 8 bytes, the lowest first. Patterns that agree to that have one
/// hash, wherever they were made.
/// @param positions millimetres
std::uint64_t pattern_hash(std::span<const Vec2> positions);

}  // namespace planish
