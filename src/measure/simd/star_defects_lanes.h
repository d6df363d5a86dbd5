// Included by one source file for each set of instructions.
#pragma once

#include "core/simd/arctangent.h"
#include "core/simd/stars.h"

namespace planish::PLANISH_ISA {

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
    const Vector x = load_vectors(rows);
    const auto spoke = [&](std::size_t j) {
      for (int lane = 0; lane < k_lanes; ++lane)
        rows[lane] = &sites[in_lane[lane]->ring[j]].x;
      return load_vectors(rows) - x;
    };
    const auto sum_of = [&](const auto& corner_of) {
      AngleSum sum;
      const Vector first = spoke(0);
      Vector u = first;
      for (std::size_t j = 1; j <= valence; ++j) {
        const Vector next = j < valence ? spoke(j) : first;
        const Vector normal = cross(u, next);
        sum.add(corner_of(Complex{dot(u, next), square_root(dot(normal, normal))}));
        u = next;
      }
      return sum;
    };
    const AngleSum sum = sum_of([](const Complex& corner) { return corner; });
    Real defect = sum.defect();
    const Mask lost = sum.is_lost();
    if (any(lost)) {  // edges without length, or next to none
      const Real careful = sum_of([](const Complex& corner) { return near_one(corner); }).defect();
      defect = select(lost, careful, defect);
    }
    for (int lane = 0; lane < used; ++lane)
      defects[begin + static_cast<std::size_t>(lane)] = defect[lane];
  }
}

}  // namespace planish::PLANISH_ISA
