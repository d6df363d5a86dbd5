#pragma once

#include <vector>

#include "unfold/stretch/border_bend.h"

namespace planish {

/// A border whose edges keep lengths, but those that are free, and which bends at a cost.
struct HeldBorder {
  /// @param like as BorderBend has it
  HeldBorder(const Disk& disk, BorderLengths wanted, const std::vector<Vec2>& like);

  BorderLengths lengths;
  BorderBend bend;
  /// The disk's vertices in order of elimination. What a turn costs couples the vertices beside it,
  /// past those that part them in the disk's own order, where factors would be several times as
  /// large.
  std::vector<Index> order;
};

}  // namespace planish
