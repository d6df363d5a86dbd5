#pragma once

// Arbitrary outlines of pieces from bytes.

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include <planish/pattern/piece_outline.h>

#include "fuzz/bytes.h"

namespace planish::fuzz {

/// A star around a centre: never meets itself.
/// @param turn 1 for counter-clockwise, -1 for clockwise
inline Polygon star_from(Bytes& bytes, Vec2 centre, double radius, double turn) {
  const std::size_t corners = bytes.whole(3, 24);
  Polygon loop;
  for (std::size_t k = 0; k < corners; ++k) {
    const double angle =
        turn * 6.283185307179586 * static_cast<double>(k) / static_cast<double>(corners);
    const double r = radius * (0.1 + 0.9 * static_cast<double>(bytes.byte()) / 255.0);
    loop.push_back(centre + r * Vec2{std::cos(angle), std::sin(angle)});
  }
  return loop;
}

/// Corners on a small lattice: edges overlap, turn back and cross.
inline Polygon scribble_from(Bytes& bytes) {
  const std::size_t corners = bytes.whole(0, 16);
  Polygon loop;
  for (std::size_t k = 0; k < corners; ++k) {
    const std::size_t where = bytes.byte();
    loop.push_back(
        {10.0 * static_cast<double>(where % 16), 10.0 * static_cast<double>(where / 16)});
  }
  return loop;
}

inline Polygon anywhere_from(Bytes& bytes) {
  const std::size_t corners = bytes.whole(0, 12);
  Polygon loop;
  for (std::size_t k = 0; k < corners; ++k)
    loop.push_back({bytes.any_double(), bytes.any_double()});
  return loop;
}

struct ArbitraryOutline {
  PieceOutline outline;
  bool is_simple = false;  ///< no line of it meets itself or another one
};

/// 200 mm across, but for what is anywhere.
inline ArbitraryOutline outline_from(Bytes& bytes) {
  const std::size_t kind = bytes.whole(0, 7);
  PieceOutline outline{"piece", {}};
  if (kind == 0) {
    for (std::size_t loops = bytes.whole(0, 3); loops > 0; --loops)
      outline.loops.push_back(anywhere_from(bytes));
    return {outline, false};
  }
  if (kind <= 2) {
    for (std::size_t loops = bytes.whole(1, 3); loops > 0; --loops)
      outline.loops.push_back(scribble_from(bytes));
    return {outline, false};
  }
  outline.loops.push_back(star_from(bytes, {}, 100.0, 1.0));
  // Corners of the star are 10 mm from its centre at least, and its edges 5 mm.
  if (kind == 7) outline.loops.push_back(star_from(bytes, {}, 4.9, -1.0));
  return {outline, true};
}

}  // namespace planish::fuzz
