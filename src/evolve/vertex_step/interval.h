#pragma once

#include <planish/core/vec.h>

namespace planish {

/// Closed interval.
struct Interval {
  double low = 0.0, high = 0.0;
};

/// The part of an interval of steps from x along `direction` that stays within `radius` of origin.
/// Always holds 0.
Interval within_sphere(Interval steps, Vec3 x, Vec3 direction, Vec3 origin, double radius);

}  // namespace planish
