#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "unfold/stretch/least_stretch.h"

namespace planish {

/// A pattern of little stretch whose holes do not cross themselves, where that of least stretch has
/// some that do. First the holes are covered by fans, as in `filled`, which cannot turn over; then,
/// round after round, by a triangulation of what they have become, at rest as it is, so that it
/// resists turning over and little else (as the scaffold of Jiang, Schaefer and Panozzo, Simplicial
/// complex augmentation framework for bijective maps, 2017). It ends when a round takes less than
/// 1 % of the energy.
/// @param filled as with_holes_filled() makes it
/// @param start of `filled`, without flipped triangles
/// @return nothing where a hole crosses a part of the border all the same
std::optional<LeastStretch> with_open_holes(const Disk& disk, const Disk& filled,
                                            std::vector<Vec2> start, int max_iterations,
                                            ThreadPool& pool,
                                            const std::function<void()>& after_step);

}  // namespace planish
