#pragma once

#include <functional>
#include <span>
#include <vector>

#include "unfold/disk/disk.h"
#include "unfold/stretch/held_border.h"
#include "unfold/stretch/least_stretch.h"

namespace planish {

/// Minimises the symmetric Dirichlet energy among the flat disks without flipped triangles whose
/// border edges, but those that are free, have the lengths given (docs/unfold.md): Newton steps
/// with multipliers, judged by the energy plus a price on what lengths are off by. To the energy
/// belongs what it costs to bend the border (TurnBending).
/// @param start without flipped triangles; its border may have other lengths
/// @return the lengths are kept if `matched`
struct MatchedBorder {
  LeastStretch result;
  bool matched = false;
};
MatchedBorder match_border(const Disk& disk, const HeldBorder& border, std::vector<Vec2> start,
                           int max_iterations, ThreadPool& pool,
                           const std::function<void()>& after_step);

/// A flat disk whose border edges have the lengths given, however stretched the inside is: the
/// border inscribed in a circle, every inner vertex at the mean of its neighbours. Triangles may
/// only be flipped by rounding. @pre no holes
std::vector<Vec2> circle_start(const Disk& disk, std::span<const double> lengths, ThreadPool& pool);

}  // namespace planish
