#include "pattern/curves/piece_math.h"

#include <array>
#include <cstddef>

#include "core/math.h"
#include "pattern/polygon/plane.h"

namespace planish {

namespace {

PlaceOnPiece place_on(Vec2 start, const LineTo& line, double t) {
  const Vec2 way = line.end - start;
  return {start + t * way, way, {}};
}

PlaceOnPiece place_on(Vec2 start, const ArcTo& arc, double t) {
  const Circle circle = circle_of(start, arc);
  const auto [sine, cosine] = math::sincos(t * circle.angle);
  const Vec2 out = start - circle.middle;
  const Vec2 turned = {cosine * out.x - sine * out.y, sine * out.x + cosine * out.y};
  return {circle.middle + turned, circle.angle * Vec2{-turned.y, turned.x},
          -circle.angle * circle.angle * turned};
}

PlaceOnPiece place_on(Vec2 start, const CubicTo& cubic, double t) {
  const double s = 1.0 - t;
  const Vec2 a = cubic.first - start, b = cubic.second - cubic.first, c = cubic.end - cubic.second;
  const Vec2 at = s * s * s * start + 3.0 * s * s * t * cubic.first +
                  3.0 * s * t * t * cubic.second + t * t * t * cubic.end;
  return {at, 3.0 * (s * s * a + 2.0 * s * t * b + t * t * c), 6.0 * (s * (b - a) + t * (c - b))};
}

}  // namespace

Vec2 end_of(const CurvePiece& piece) {
  return std::visit([](const auto& some) { return some.end; }, piece);
}

PlaceOnPiece place_on(Vec2 start, const CurvePiece& piece, double t) {
  return std::visit([&](const auto& some) { return place_on(start, some, t); }, piece);
}

Circle circle_of(Vec2 start, const ArcTo& arc) {
  // The angle between a chord and the tangent at its end is half of what the chord subtends.
  const Vec2 half = arc.middle - start, chord = arc.end - start;
  const double angle = 4.0 * turn_between(half, chord);
  const double radius = 0.5 * norm(half) / math::sin(0.25 * std::abs(angle));
  const Vec2 along = direction_of(chord);
  const Vec2 left = {-along.y, along.x};
  const double side = angle > 0.0 ? 1.0 : -1.0;
  return {arc.middle + (side * radius) * left, radius, angle};
}

std::vector<CubicTo> cubics_along(Vec2 start, const ArcTo& arc) {
  const double angle = circle_of(start, arc).angle;
  const int count = std::max(1, static_cast<int>(std::ceil(std::abs(angle) / 1.5708 - 1e-9)));
  // Control points on the tangents at the ends, 4/3 tan(angle / 4) radii from them.
  const double part = angle / count;
  const double reach = 4.0 / 3.0 * math::tan(0.25 * part) / part / count;
  std::vector<CubicTo> cubics;
  PlaceOnPiece from = place_on(start, arc, 0.0);
  for (int k = 1; k <= count; ++k) {
    PlaceOnPiece to = place_on(start, arc, static_cast<double>(k) / count);
    if (k == count) to.at = arc.end;
    cubics.push_back({from.at + reach * from.speed, to.at - reach * to.speed, to.at});
    from = to;
  }
  return cubics;
}

double length_of(Vec2 start, const CurvePiece& piece) {
  if (const auto* line = std::get_if<LineTo>(&piece)) return norm(line->end - start);
  if (const auto* arc = std::get_if<ArcTo>(&piece)) {
    const Circle circle = circle_of(start, *arc);
    return circle.radius * std::abs(circle.angle);
  }
  // Gauss's rule of five points on each of sixteen parts.
  constexpr std::array<double, 3> nodes = {0.0, 0.5384693101056831, 0.9061798459386640};
  constexpr std::array<double, 3> weights = {0.5688888888888889, 0.4786286704993665,
                                             0.2369268850561891};
  constexpr int parts = 16;
  double length = 0.0;
  for (int part = 0; part < parts; ++part) {
    const double middle = (part + 0.5) / parts, half = 0.5 / parts;
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      const double speeds = norm(place_on(start, piece, middle - half * nodes[k]).speed) +
                            norm(place_on(start, piece, middle + half * nodes[k]).speed);
      length += half * weights[k] * (k == 0 ? 0.5 : 1.0) * speeds;
    }
  }
  return length;
}

double length_of(const Curve& curve) {
  double length = 0.0;
  Vec2 from = curve.start;
  for (const CurvePiece& piece : curve.pieces) {
    length += length_of(from, piece);
    from = end_of(piece);
  }
  return length;
}

Curve reversed(const Curve& curve) {
  if (curve.pieces.empty()) return curve;
  Curve other{end_of(curve.pieces.back()), {}};
  for (std::size_t k = curve.pieces.size(); k-- > 0;) {
    const Vec2 end = k > 0 ? end_of(curve.pieces[k - 1]) : curve.start;
    const CurvePiece& piece = curve.pieces[k];
    if (const auto* cubic = std::get_if<CubicTo>(&piece)) {
      other.pieces.emplace_back(CubicTo{cubic->second, cubic->first, end});
    } else if (const auto* arc = std::get_if<ArcTo>(&piece)) {
      other.pieces.emplace_back(ArcTo{arc->middle, end});
    } else {
      other.pieces.emplace_back(LineTo{end});
    }
  }
  return other;
}

Curve moved(const Curve& curve, const std::function<Vec2(Vec2)>& motion) {
  Curve other{motion(curve.start), {}};
  for (const CurvePiece& piece : curve.pieces) {
    if (const auto* cubic = std::get_if<CubicTo>(&piece)) {
      other.pieces.emplace_back(
          CubicTo{motion(cubic->first), motion(cubic->second), motion(cubic->end)});
    } else if (const auto* arc = std::get_if<ArcTo>(&piece)) {
      other.pieces.emplace_back(ArcTo{motion(arc->middle), motion(arc->end)});
    } else {
      other.pieces.emplace_back(LineTo{motion(end_of(piece))});
    }
  }
  return other;
}

}  // namespace planish
