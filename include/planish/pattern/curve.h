#pragma once

#include <span>
#include <variant>
#include <vector>

#include <planish/pattern/piece_outline.h>

namespace planish {

/// Straight on to `end`.
struct LineTo {
  Vec2 end;  ///< millimetres
};

/// Along an arc of a circle, less than a full turn.
struct ArcTo {
  Vec2 middle, end;  ///< half way along the arc, and its end; millimetres
};

/// Along a cubic Bézier curve.
struct CubicTo {
  Vec2 first, second, end;  ///< the control points after the start, and the end; millimetres
};

/// A part of a curve, which begins where the part before it ends.
using CurvePiece = std::variant<LineTo, ArcTo, CubicTo>;

/// Where a piece ends.
Vec2 end_of(const CurvePiece& piece);

/// A line made of few pieces. A closed one ends where it starts.
struct Curve {
  Vec2 start;                      ///< millimetres
  std::vector<CurvePiece> pieces;  ///< in order
};

/// The length of a curve to 1e-9 of it, millimetres.
double length_of(const Curve& curve);

/// How near a line of fewer points or pieces stays to the line that it stands for.
struct LineFit {
  /// Of all points, millimetres; 0: the line itself.
  double tolerance = 0.1;
  /// Of the length between two corners, millimetres: small where it is sewn to a length that
  /// matches.
  double length_tolerance = 0.02;
};

/// A curve in few pieces along each closed line. It begins at the first corner of its line. Between
/// two corners it is one line, one arc, or cubics with a common tangent where they meet. Where no
/// curve keeps both tolerances, the line itself is what comes out. docs/pattern.md says what counts
/// as a corner.
std::vector<Curve> fit_curves(std::span<const Polygon> loops, const LineFit& fit = {});

/// A closed line of few points along another one, with the same corners. Between two corners its
/// points lie a little outside of a bend and the middles of its chords inside, so that the length
/// stays. Where no line of fewer points keeps both tolerances, a stretch stays as it is.
/// @param kept places that are to be points where they are on the line, to 0.001 mm, such as those
/// of
///   notches; millimetres
Polygon simplify_polyline(const Polygon& loop, const LineFit& fit = {.tolerance = 0.15},
                          std::span<const Vec2> kept = {});

/// Closed lines in fewer points and in curves, for formats that take these.
struct FittedLines {
  std::vector<Polygon> few;   ///< simplify_polyline() of each line; empty: nothing was fitted
  std::vector<Curve> curves;  ///< fit_curves() of each line; empty: nothing was fitted
};

}  // namespace planish
