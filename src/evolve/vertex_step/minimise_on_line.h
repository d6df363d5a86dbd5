#pragma once

#include <functional>

#include "evolve/vertex_step/interval.h"

namespace planish {

/// A function of one variable at one place, with its first two derivatives.
struct LineSample {
  double value = 0.0, slope = 0.0, curvature = 0.0;
};

using LineFunction = std::function<LineSample(double)>;

struct LineMinimum {
  double at = 0.0;
  LineSample sample;
  int evaluations = 0;  ///< that of the start included
};

/// Goes down from `start` to a minimum of f by the interior-reflective trust-region Newton method
/// of Coleman and Li (1996), which for one variable needs no subspace. All positions are strictly
/// inside the interval; f never rises; a place where f is not a number is none to go to. Ends after
/// at most 100 evaluations.
/// @pre start is strictly inside
LineMinimum minimise_on_line(const LineFunction& f, Interval interval, double start);

}  // namespace planish
