// Included by one source file for each set of instructions.
#pragma once

#include "core/lanes/arctangent.h"
#include "core/lanes/stars.h"

namespace planish::PLANISH_ISA {

/// The corner at a size near 1, whatever the size of the triangle; no angle where it has none.
inline Complex near_one(const Complex& corner) {
  const Real size = greatest(absolute(corner.re), absolute(corner.im));
  const Real factor = exponent_off(size);
  return {select(size > 0.0, factor * corner.re, all(1.0)), factor * corner.im};
}

[[gnu::flatten]] inline void star_defects(const Site* sites, const Star* stars, std::size_t count,
                                          std::size_t valence, double* defects) {
  for (std::size_t begin = 0; begin < count; begin += k_lanes) {
    const int used = count - begin < k_lanes ? static_cast<int>(count - begin) : k_lanes;
    const Star* in_lane[k_lanes];
    const double* rows[k_lanes];
    for (int lane = 0; lane < k_lanes; ++lane) {
      in_lane[lane] = stars + begin + (lane < used ? lane : 0);
      rows[lane] = &sites[in_lane[lane]->center].x;
    }
    const Columns center = load_columns(rows);
    const Vector x{center.c0, center.c1, center.c2};
    const auto spoke = [&](std::size_t j) {
      for (int lane = 0; lane < k_lanes; ++lane)
        rows[lane] = &sites[in_lane[lane]->ring[j]].x;
      const Columns place = load_columns(rows);
      return Vector{place.c0, place.c1, place.c2} - x;
    };
    Vector previous = spoke(valence - 1);
    AngleSum sum;
    for (std::size_t j = 0; j < valence; ++j) {
      const Vector u = spoke(j), normal = cross(previous, u);
      sum.add(near_one({dot(previous, u), square_root(dot(normal, normal))}));
      previous = u;
    }
    const Real defect = sum.defect();
    for (int lane = 0; lane < used; ++lane)
      defects[begin + static_cast<std::size_t>(lane)] = defect[lane];
  }
}

}  // namespace planish::PLANISH_ISA
