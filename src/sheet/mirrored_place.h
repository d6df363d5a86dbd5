#pragma once

#include <cmath>

namespace planish {

/// The coordinate of a place's mirror image, millimetres, for files that have thousandths: what
/// they write of both adds up to `sum`, to the last digit. A place half way between two thousandths
/// is mirrored where files have it, as its image would be rounded away from it.
/// @param sum in whole thousandths
inline double mirrored_place(double sum, double place) {
  constexpr double k_steps = 1000.0, k_near = 1e-6;
  const double steps = k_steps * place;
  const bool is_half_way = std::abs(steps - std::floor(steps) - 0.5) < k_near;
  return sum - (is_half_way ? std::round(steps) / k_steps : place);
}

}  // namespace planish
