#pragma once

#include <span>

#include <planish/pattern/piece_outline.h>

namespace planish {

/// The box around loops; nothing but (0, 0) where there are none.
struct LoopBox {
  Vec2 low, high;
  Vec2 size() const { return high - low; }
};
LoopBox loop_box(std::span<const Polygon> loops);
/// The box around points.
/// @pre there are any
LoopBox box_around(std::span<const Vec2> points);

}  // namespace planish
