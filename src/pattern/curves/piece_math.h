#pragma once

#include <functional>
#include <vector>

#include <planish/pattern/curve.h>

namespace planish {

/// A place on a piece of a curve.
struct PlaceOnPiece {
  Vec2 at;     ///< millimetres
  Vec2 speed;  ///< first derivative by the parameter
  Vec2 bend;   ///< second derivative
};

/// @param start where the piece begins
/// @param t its parameter, 0 to 1
PlaceOnPiece place_on(Vec2 start, const CurvePiece& piece, double t);

/// The circle of an arc.
struct Circle {
  Vec2 middle;
  double radius = 0.0;
  double angle = 0.0;  ///< that the arc sweeps, radians, > 0 where it turns left
};
/// @pre start, arc.middle and arc.end are no straight line
Circle circle_of(Vec2 start, const ArcTo& arc);

/// An arc as cubics of at most a quarter of a circle, within 0.0003 of the radius of it.
std::vector<CubicTo> cubics_along(Vec2 start, const ArcTo& arc);

/// The length of a piece to 1e-9 of it.
double length_of(Vec2 start, const CurvePiece& piece);

/// The other way round.
Curve reversed(const Curve& curve);

/// @param motion that keeps lengths
Curve moved(const Curve& curve, const std::function<Vec2(Vec2)>& motion);

}  // namespace planish
