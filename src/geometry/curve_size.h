#pragma once

#include <planish/core/vec.h>

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

}  // namespace planish
