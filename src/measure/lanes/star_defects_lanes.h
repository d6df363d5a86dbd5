// Included by one source file for each set of instructions.
#pragma once

#include "core/lanes/arctangent.h"
#include "core/lanes/stars.h"

namespace planish::PLANISH_ISA {

inline void star_defects(const Places& places, const Star* stars, std::size_t count,
                         std::size_t valence, double* defects) {
  for (std::size_t begin = 0; begin < count; begin += k_lanes) {
    const int used = count - begin < k_lanes ? static_cast<int>(count - begin) : k_lanes;
    const auto star = [&](int lane) -> const Star& {
      return stars[begin + static_cast<std::size_t>(lane < used ? lane : 0)];
    };
    const auto place = [&](int lane, std::uint32_t number, Vector& v) {
      const double* p = places.first + places.stride * number;
      v.x[lane] = p[0], v.y[lane] = p[1], v.z[lane] = p[2];
    };
    Vector x{}, previous{}, next{};
    for (int lane = 0; lane < k_lanes; ++lane) {
      place(lane, star(lane).center, x);
      place(lane, star(lane).ring[valence - 1], previous);
    }
    const Real scale = all(places.scale);
    x = scale * x;
    previous = scale * previous - x;
    AngleSum sum;
    for (std::size_t j = 0; j < valence; ++j) {
      for (int lane = 0; lane < k_lanes; ++lane)
        place(lane, star(lane).ring[j], next);
      const Vector u = scale * next - x, normal = cross(previous, u);
      sum.add({dot(previous, u), square_root(dot(normal, normal))});
      previous = u;
    }
    const Real defect = sum.defect();
    for (int lane = 0; lane < used; ++lane)
      defects[begin + static_cast<std::size_t>(lane)] = defect[lane];
  }
}

}  // namespace planish::PLANISH_ISA
