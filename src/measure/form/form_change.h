#pragma once

#include <span>

#include <planish/measure/form_change.h>
#include <planish/mesh/patch.h>

namespace planish {

/// What a person sees of the change. Figures are those of docs/fairness.md; a design with one
/// place has none. O(n log n).
/// @param after one position per vertex of `design`
/// @param is_noisy whether short waves of the design look like noise (find_scan_noise()): then what
///   is bent more without them counts too
FormChange form_change_of(const Patch& design, std::span<const Vec3> after, bool is_noisy);

}  // namespace planish
