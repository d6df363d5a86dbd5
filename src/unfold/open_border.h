#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "unfold/disk/disk.h"

namespace planish {

/// A layout whose border was moved apart where it crossed itself.
struct OpenBorder {
  std::vector<Vec2> flat;     ///< by the disk's numbers
  std::size_t crossings = 0;  ///< before
  double largest_move = 0.0;  ///< in the disk's units
  Index vertex = 0;           ///< of the disk: the one that moved most
};

/// Moves border vertices apart until the border no longer crosses itself, each by `most` at most.
/// Nothing where that does not open it, where there are more than 100 crossings, and where a
/// triangle would turn over.
/// @param most in the disk's units
std::optional<OpenBorder> open_border(const Disk& disk, std::span<const Vec2> flat, double most);

}  // namespace planish
