#pragma once

#include <algorithm>

namespace planish {

/// What an edge of a seam gets in the patterns of both sides: the mean of its lengths there, but
/// within a tenth of its own. In patterns of least stretch edges at the tips of slits may be
/// several times as long or short.
inline double common_length(double mean, double own) {
  constexpr double k_most = 0.1;
  return std::clamp(mean, (1.0 - k_most) * own, (1.0 + k_most) * own);
}

}  // namespace planish
