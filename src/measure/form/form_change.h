#pragma once

#include <span>

#include <planish/measure/form_change.h>
#include <planish/mesh/patch.h>

namespace planish {

/// What a person sees of the change. Figures are those of docs/fairness.md; a design with one
/// place has none. O(n log n).
/// @param after one position per vertex of `design`
FormChange form_change_of(const Patch& design, std::span<const Vec3> after);

}  // namespace planish
