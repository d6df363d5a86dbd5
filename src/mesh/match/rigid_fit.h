#pragma once

#include <span>
#include <vector>

#include "mesh/match/twins.h"

namespace planish {

/// The motion that brings points nearest to others (least squares; Kabsch, "A solution for the best
/// rotation to relate two sets of vectors", 1976), turned mirror where asked. Where one whose axes
/// are those of space is as near to within the tolerance, as between the left and the right side of
/// a model, that one, without rounding in its turn.
/// @param pair point of `from` -> point of `to`
RigidMotion rigid_fit(std::span<const Vec3> from, std::span<const Vec3> to,
                      std::span<const Index> pair, bool mirrored, double tolerance);

/// Whether the motion brings every point to its partner to within the tolerance.
bool brings_together(const RigidMotion& motion, std::span<const Vec3> from,
                     std::span<const Vec3> to, std::span<const Index> pair, double tolerance);

}  // namespace planish
