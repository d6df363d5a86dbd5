#pragma once

#include <span>

#include <planish/pattern/piece_outline.h>

namespace planish {

/// A straight band without anything in it.
struct FreeStrip {
  Vec2 middle;
  double length = 0.0;  ///< 0: there is none
};

/// The longest strip in a direction that is within the loops (by even and odd) and crosses none of
/// their edges, among 41 lines over all of them. Of those that are long enough the one nearest to
/// the middle of the outer loop, which is the first.
/// @param direction of length 1
/// @param half_width of the strip, millimetres
/// @param enough a length that is not worth exceeding, millimetres
FreeStrip longest_strip(std::span<const Polygon> loops, Vec2 direction, double half_width,
                        double enough);

}  // namespace planish
