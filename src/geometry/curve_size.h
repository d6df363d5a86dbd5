#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <planish/core/vec.h>

#include "core/neumaier_sum.h"
#include "geometry/box.h"

namespace planish {

/// How large a closed curve is, in model units.
struct CurveSize {
  double reach = 0.0;   ///< the diagonal of its box
  double length = 0.0;  ///< a jagged hole may be longer than the border around it
};

/// Whether the first of two curves of a border rather is the outer one: it reaches farther, or in a
/// tie is longer. Where that is equal too, it is not.
inline bool is_larger(const CurveSize& a, const CurveSize& b) {
  constexpr double k_same = 1.0 + 1e-9;
  if (a.reach > k_same * b.reach) return true;
  return a.reach * k_same >= b.reach && a.length > b.length;
}

/// The diagonal of a box.
inline double diagonal_of(const Box& box) {
  return norm(box.high - box.low);
}

/// Area of the loop's projection along its mean normal: what it encloses where it lies in a plane.
inline double enclosed_area(std::span<const Vec3> loop) {
  NeumaierSum x, y, z;
  for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
    const Vec3 doubled = cross(loop[i] - loop[0], loop[i + 1] - loop[0]);
    x.add(doubled.x);
    y.add(doubled.y);
    z.add(doubled.z);
  }
  return 0.5 * norm(Vec3{x.value(), y.value(), z.value()});
}

/// Of a closed loop of vertices.
/// @param scale that of unit_scale() where squares of lengths have to stay in range
inline CurveSize size_of_loop(std::span<const Vec3> positions, std::span<const Index> loop,
                              double scale = 1.0) {
  CurveSize size;
  Box box;
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const Vec3 here = scale * positions[loop[k]];
    size.length += norm(scale * positions[loop[(k + 1) % loop.size()]] - here);
    box.add(here);
  }
  size.reach = diagonal_of(box);
  return size;
}

/// The number of the outer one of the border loops of one surface: the largest, of equal ones the
/// first. @pre there is one
inline std::size_t outer_loop(std::span<const CurveSize> sizes) {
  std::size_t outer = 0;
  for (std::size_t k = 1; k < sizes.size(); ++k) {
    if (is_larger(sizes[k], sizes[outer])) outer = k;
  }
  return outer;
}

/// Of each loop.
inline std::vector<CurveSize> sizes_of_loops(std::span<const Vec3> positions,
                                             std::span<const std::vector<Index>> loops,
                                             double scale = 1.0) {
  std::vector<CurveSize> sizes;
  sizes.reserve(loops.size());
  for (const std::vector<Index>& loop : loops)
    sizes.push_back(size_of_loop(positions, loop, scale));
  return sizes;
}

}  // namespace planish
