#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

#include <planish/pattern/curve.h>

#include "pattern/curves/corners.h"
#include "pattern/curves/fit_cubic.h"
#include "pattern/curves/piece_math.h"
#include "pattern/polygon/plane.h"

namespace planish {

namespace {

// Millimetres: where the length is missed the tolerance is halved down to it.
constexpr double k_least_curve_tolerance = 0.0125;
constexpr double k_straight = 0.9998;  // cosine between a line and the direction at its end

bool is_straight(std::span<const Vec2> points, double tolerance) {
  const Vec2 chord = points.back() - points.front();
  if (!(norm(chord) > 0.0)) return false;
  const Vec2 along = direction_of(chord);
  return std::all_of(points.begin(), points.end(), [&](Vec2 p) {
    const double way = dot(p - points.front(), along);
    return std::abs(cross(along, p - points.front())) <= tolerance && way >= -tolerance &&
           way <= norm(chord) + tolerance;
  });
}

/// The arc from end to end that is nearest to the points, or none where the line is nearer.
std::optional<ArcTo> arc_along(std::span<const Vec2> points, double tolerance) {
  const Vec2 chord = points.back() - points.front();
  if (points.size() < 4 || !(norm(chord) > tolerance)) return std::nullopt;
  const double half = 0.5 * norm(chord);
  const Vec2 along = direction_of(chord), left = {-along.y, along.x};
  const Vec2 middle = points.front() + 0.5 * chord;
  // Of a circle through both ends whose middle is k to the left: x^2 + y^2 - 2 k y = half^2.
  double above = 0.0, below = 0.0;
  for (const Vec2 p : points) {
    const double x = dot(p - middle, along), y = dot(p - middle, left);
    above += y * (x * x + y * y - half * half);
    below += 2.0 * y * y;
  }
  if (!(below > 0.0)) return std::nullopt;
  const double k = above / below, radius = std::sqrt(k * k + half * half);
  const Vec2 center = middle + k * left;
  const Vec2 inner = points[points.size() / 2];
  const double side = dot(inner - middle, left) > 0.0 ? 1.0 : -1.0;
  const ArcTo arc = {center + (side * radius) * left, points.back()};
  const bool follows = std::all_of(points.begin(), points.end(), [&](Vec2 p) {
    return std::abs(norm(p - center) - radius) <= tolerance;
  });
  if (!follows) return std::nullopt;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Vec2 way = points[i - 1] + 0.5 * (points[i] - points[i - 1]);
    const bool goes_on = side * cross(points[i] - center, points[i - 1] - center) > 0.0;
    if (!goes_on || std::abs(norm(way - center) - radius) > tolerance) return std::nullopt;
  }
  return arc;
}

/// The direction of a line at one of its points, of a parabola along the points beside it.
Vec2 direction_at(std::span<const Vec2> points, std::size_t at) {
  constexpr std::size_t reach = 3;
  const std::size_t from = at - std::min(at, reach);
  const std::size_t to = std::min(at + reach, points.size() - 1);
  // Least squares of a + b s + c s^2 by the way s, with the point itself for a.
  double s2 = 0.0, s3 = 0.0, s4 = 0.0;
  Vec2 first, second;
  for (std::size_t i = from; i <= to; ++i) {
    const auto span = i < at ? points.subspan(i, at - i + 1) : points.subspan(at, i - at + 1);
    const double s = (i < at ? -1.0 : 1.0) * length_of_line(span);
    const Vec2 apart = points[i] - points[at];
    s2 += s * s;
    s3 += s * s * s;
    s4 += s * s * s * s;
    first = first + s * apart;
    second = second + s * s * apart;
  }
  const double below = s2 * s4 - s3 * s3;
  Vec2 along = points[to] - points[from];
  if (below > 1e-9 * s2 * s4) along = 1.0 / below * (s4 * first - s3 * second);
  if (!(norm(along) > 0.0)) along = points[to] - points[at];
  return direction_of(along);
}

bool goes_along(Vec2 chord, const std::optional<Vec2>& direction) {
  return !direction || dot(direction_of(chord), *direction) >= k_straight;
}

/// Cubics and lines along the points; where one does not follow them, two do, divided where it is
/// farthest off.
void append_pieces(std::span<const Vec2> points, const EndDirections& ends, double tolerance,
                   std::vector<CurvePiece>& pieces) {
  const Vec2 chord = points.back() - points.front();
  const bool may_be_line =
      norm(chord) > 0.0 && goes_along(chord, ends.first) && goes_along(chord, ends.last);
  if (points.size() == 2 || (may_be_line && is_straight(points, tolerance))) {
    pieces.emplace_back(LineTo{points.back()});
    return;
  }
  const FittedCubic fitted = fit_cubic(points, ends, tolerance);
  if (fitted.distance <= tolerance) {
    pieces.emplace_back(fitted.cubic);
    return;
  }
  const std::size_t last = points.size() - 1, margin = std::max<std::size_t>(1, last / 8);
  const std::size_t at = std::clamp(fitted.worst, margin, last - margin);
  const Vec2 direction = direction_at(points, at);
  append_pieces(points.first(at + 1), {ends.first, direction}, tolerance, pieces);
  append_pieces(points.subspan(at), {direction, ends.last}, tolerance, pieces);
}

std::vector<CurvePiece> pieces_along(std::span<const Vec2> points, const EndDirections& ends,
                                     double tolerance) {
  if (!ends.first) {
    if (is_straight(points, tolerance)) return {LineTo{points.back()}};
    if (const auto arc = arc_along(points, tolerance)) return {*arc};
  }
  std::vector<CurvePiece> pieces;
  append_pieces(points, ends, tolerance, pieces);
  return pieces;
}

/// From corner to corner, as long as the line.
std::vector<CurvePiece> fit_stretch(std::span<const Vec2> points, const EndDirections& ends,
                                    const LineFit& fit) {
  const double length = length_of_line(points);
  double tolerance = fit.tolerance;
  for (; tolerance > 0.0; tolerance = tolerance > k_least_curve_tolerance ? 0.5 * tolerance : 0.0) {
    std::vector<CurvePiece> pieces = pieces_along(points, ends, tolerance);
    if (std::abs(length_of(Curve{points.front(), pieces}) - length) <= fit.length_tolerance)
      return pieces;
  }
  std::vector<CurvePiece> pieces;
  pieces.reserve(points.size() - 1);
  for (const Vec2 p : points.subspan(1))
    pieces.emplace_back(LineTo{p});
  return pieces;
}

/// The direction in which a line without corners passes its first point.
EndDirections directions_at_start(const Polygon& loop) {
  const std::size_t reach = std::min<std::size_t>(6, loop.size() / 3);
  Polygon around;
  for (std::size_t k = 0; k <= 2 * reach; ++k)
    around.push_back(loop[(loop.size() - reach + k) % loop.size()]);
  const Vec2 along = direction_at(around, reach);
  return {along, along};
}

Curve fit_curve(const Polygon& line, const LineFit& fit) {
  const Polygon loop = without_repeats(line);
  if (loop.size() < 3) return {loop.empty() ? Vec2{} : loop.front(), {}};
  const std::vector<std::size_t> corners = corners_of(loop);
  const std::vector<Polygon> stretches = stretches_of(loop, corners);
  const EndDirections ends = corners.empty() ? directions_at_start(loop) : EndDirections{};
  Curve curve{stretches.front().front(), {}};
  for (const Polygon& points : stretches) {
    const std::vector<CurvePiece> pieces = fit_stretch(points, ends, fit);
    curve.pieces.insert(curve.pieces.end(), pieces.begin(), pieces.end());
  }
  return curve;
}

}  // namespace

std::vector<Curve> fit_curves(std::span<const Polygon> loops, const LineFit& fit) {
  std::vector<Curve> curves;
  curves.reserve(loops.size());
  for (const Polygon& loop : loops)
    curves.push_back(fit_curve(loop, fit));
  return curves;
}

}  // namespace planish
