#include "pattern/allowance/bare_ends.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "pattern/polygon/border_walk.h"
#include "pattern/polygon/plane.h"

namespace planish {

namespace {

// How far along its edges an allowance may go on until it is free of the line, in widths.
constexpr double k_most_way = 4.0;

double height_over(const EndLine& line, Vec2 p) {
  return cross(line.along, p - line.at);
}

/// The vertices and edges from a corner on, either way round.
class WalkAway {
 public:
  WalkAway(const WideLoop& wide, std::size_t corner, bool forward)
      : wide_(wide), corner_(corner), forward_(forward) {}

  std::size_t count() const { return wide_.points.size(); }
  std::size_t vertex(std::size_t steps) const {
    return (corner_ + (forward_ ? steps : count() - steps % count())) % count();
  }
  /// The edge from that many steps on.
  std::size_t edge(std::size_t steps) const { return forward_ ? vertex(steps) : vertex(steps + 1); }
  double width(std::size_t steps) const { return wide_.widths[edge(steps)]; }
  Vec2 point(std::size_t steps) const { return wide_.points[vertex(steps)]; }

 private:
  const WideLoop& wide_;
  std::size_t corner_;
  bool forward_;
};

/// The line of the edges without an allowance at a corner, as seen from as far off as the allowance
/// beside them is wide: single edges may be jags.
EndLine line_of_bare_edges(const WalkAway& bare, const BorderWalk& walk, double width,
                           bool forward) {
  double length = 0.0;
  for (std::size_t k = 0; k < bare.count() && length < width && !(bare.width(k) > 0.0); ++k)
    length += norm(bare.point(k + 1) - bare.point(k));
  const double far = std::min(width, length), way = walk.way_to(bare.vertex(0));
  const Vec2 corner = bare.point(0), away = walk.at(forward ? way + far : way - far);
  return {corner, direction_of(forward ? away - corner : corner - away)};
}

/// Whether the border turns at a corner from the line to the edges with an allowance, as seen from
/// as far off as that is wide.
bool turns(const WalkAway& away, const BorderWalk& walk, const EndLine& line, bool forward) {
  constexpr double k_least_turn = 25.0 * std::numbers::pi / 180.0;
  const double far = std::min(away.width(0), 0.25 * walk.length());
  const double way = walk.way_to(away.vertex(0));
  const Vec2 along = walk.at(forward ? way + far : way - far) - away.point(0);
  return std::abs(turn_between(line.along, forward ? along : -1.0 * along)) >= k_least_turn;
}

/// The edges and joins at which the allowance from a corner on crosses the line.
struct Crossing {
  std::vector<std::size_t> edges, joins;
  bool comes_free = false;
};

Crossing crossing_of(const WideLoop& wide, const WalkAway& away, const EndLine& line) {
  const double most = k_most_way * away.width(0), rounding = 1e-9 * away.width(0);
  Crossing crossing;
  double way = 0.0;
  for (std::size_t k = 0; k + 1 < away.count() && away.width(k) > 0.0; ++k) {
    const std::size_t edge = away.edge(k);
    const Vec2 near = away.point(k), far = away.point(k + 1);
    const Vec2 out = away.width(k) * outwards(wide.direction(edge));
    if (k > 0) crossing.joins.push_back(away.vertex(k));
    const double before = height_over(line, near + out), after = height_over(line, far + out);
    crossing.comes_free = before >= -rounding;
    if (crossing.comes_free || !(height_over(line, far) > 0.0)) break;
    crossing.edges.push_back(edge);
    const double length = norm(far - near);
    if (after >= 0.0) {
      crossing.comes_free = way + before / (before - after) * length <= most;
      break;
    }
    way += length;
    if (way > most) break;
  }
  return crossing;
}

/// The corner that the piece has where it is opened at the line, which ends an allowance.
OutlineCorner opened_corner(OutlineCorner corner, const EndLine& line) {
  const bool is_before = corner.width_before > 0.0;
  const Vec2 along = is_before ? corner.before : corner.after;
  (is_before ? corner.after : corner.before) = along - 2.0 * dot(along, line.along) * line.along;
  corner.width_before = corner.width_after = std::max(corner.width_before, corner.width_after);
  return corner;
}

Polygon left_of(const Polygon& polygon, const EndLine& line) {
  Polygon left;
  left.reserve(polygon.size() + 2);
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    const double at_a = height_over(line, a), at_b = height_over(line, b);
    if (at_a >= 0.0) left.push_back(a);
    if ((at_a >= 0.0) == (at_b >= 0.0)) continue;
    // From the end that is left, so that both ways along an edge give the same place.
    left.push_back(at_a >= 0.0 ? a + at_a / (at_a - at_b) * (b - a)
                               : b + at_b / (at_b - at_a) * (a - b));
  }
  return left;
}

}  // namespace

Polygon left_of(Polygon polygon, std::span<const EndLine> lines) {
  for (const EndLine& line : lines)
    polygon = left_of(polygon, line);
  return polygon;
}

BareEnds bare_ends(const WideLoop& wide, Corners corners, double mitre_limit) {
  const std::size_t count = wide.points.size();
  BareEnds ends{std::vector<std::optional<OutlineCorner>>(count),
                std::vector<std::vector<EndLine>>(count), std::vector<std::vector<EndLine>>(count)};
  const BorderWalk walk(wide.points);
  for (std::size_t i = 0; i < count; ++i) {
    const bool bare_before = !(wide.widths[(i + count - 1) % count] > 0.0);
    const bool bare_after = !(wide.widths[i] > 0.0);
    if (bare_before == bare_after) continue;
    const WalkAway away(wide, i, bare_before), bare(wide, i, bare_after);
    const EndLine line = line_of_bare_edges(bare, walk, away.width(0), bare_after);
    if (!wide.folds[bare.edge(0)] && !turns(away, walk, line, bare_before)) continue;
    const Crossing crossing = crossing_of(wide, away, line);
    if (!crossing.comes_free) continue;
    ends.corners[i] = opened_corner(wide.corner(i, corners, mitre_limit), line);
    ends.of_join[i].push_back(line);
    for (const std::size_t vertex : crossing.joins)
      ends.of_join[vertex].push_back(line);
    for (const std::size_t edge : crossing.edges)
      ends.of_edge[edge].push_back(line);
  }
  return ends;
}

}  // namespace planish
