#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <numbers>
#include <optional>
#include <utility>

#include <planish/core/error.h>
#include <planish/core/range.h>
#include <planish/pattern/allowance.h>

#include "core/number_text.h"
#include "geometry/crosses_itself.h"
#include "pattern/allowance/allowance_joins.h"
#include "pattern/allowance/bare_ends.h"
#include "pattern/allowance/darts.h"
#include "pattern/allowance/hems.h"
#include "pattern/polygon/border_walk.h"
#include "pattern/polygon/loop_box.h"
#include "pattern/polygon/plane.h"
#include "pattern/polygon/polygon_rays.h"
#include "pattern/polygon/winding_union.h"

namespace planish {

namespace {

std::string about(const PieceOutline& outline) {
  return "piece \"" + outline.piece + "\": ";
}

/// Millimetres with some decimals, but of absurdly large lengths as few digits as there are.
std::string length_text(double length, int decimals) {
  return std::abs(length) < 1e9 ? fixed_text(length, decimals) : number_text(length);
}

[[noreturn]] void refuse_width(const PieceOutline& outline, double width, double limit,
                               const std::string& where) {
  throw Error(ErrorCode::option_out_of_range,
              about(outline) + "the seam allowance" + where + " is " + length_text(width, 3) +
                  " mm but must be above 0 and at most the piece's length, " +
                  length_text(limit, 1) +
                  " mm; is the unit right? Numbers alone are in units of the model, 10mm are "
                  "millimetres");
}

void check_widths(const PieceOutline& outline, const Allowance& allowance) {
  const Vec2 size = loop_box(std::span(&outline.loops.front(), 1)).size();
  const double limit = std::max(size.x, size.y);
  if (allowance.edge_widths.empty()) {
    if (!(allowance.width > 0.0 && allowance.width <= limit)) {
      refuse_width(outline, allowance.width, limit, "");
    }
    return;
  }
  double widest = 0.0;
  for (const auto& widths : allowance.edge_widths) {
    for (std::size_t i = 0; i < widths.size(); ++i) {
      widest = std::max(widest, widths[i]);
      if (widths[i] >= 0.0 && widths[i] <= limit) continue;
      refuse_width(outline, widths[i], limit, " of edge " + std::to_string(i));
    }
  }
  if (!(widest > 0.0)) refuse_width(outline, widest, limit, " of every edge");
}

void check_counts(const PieceOutline& outline, const Allowance& allowance) {
  const auto fits = [&](const auto& of_loops) {
    return of_loops.empty() ||
           std::equal(of_loops.begin(), of_loops.end(), outline.loops.begin(), outline.loops.end(),
                      [](const auto& a, const auto& b) { return a.size() == b.size(); });
  };
  if (fits(allowance.edge_widths) && fits(allowance.folds) && fits(allowance.hems)) return;
  throw Error(ErrorCode::option_out_of_range,
              about(outline) + "there must be one seam allowance for each edge of each loop");
}

void check_outline(const PieceOutline& outline) {
  for (std::size_t k = 0; k < outline.loops.size(); ++k) {
    const Polygon& loop = outline.loops[k];
    const double area = signed_area(loop);
    if (!(k == 0 ? area > 0.0 : area < 0.0) || crosses_itself(loop)) {
      throw Error(ErrorCode::overlapping_outline,
                  about(outline) + (k == 0 ? "the outline" : "hole " + std::to_string(k)) +
                      " crosses itself or runs the wrong way around, so there is no one side for "
                      "a seam allowance; divide the patch or leave the allowance out");
    }
  }
}

void check(const PieceOutline& outline, const Allowance& allowance) {
  if (outline.loops.empty() || outline.loops.front().size() < 3) {
    throw Error(ErrorCode::no_triangles, about(outline) + "there is no outline");
  }
  check_counts(outline, allowance);
  check_widths(outline, allowance);
  check_range("mitre_limit", allowance.mitre_limit, {.min = 1.0});
  if (!allowance.laps) check_outline(outline);
}

WideLoop wide_loop(const PieceOutline& outline, std::size_t k, const Allowance& allowance) {
  const Polygon& loop = outline.loops[k];
  WideLoop wide;
  wide.points.reserve(loop.size());
  wide.widths.reserve(loop.size());
  wide.folds.reserve(loop.size());
  for (std::size_t i = 0; i < loop.size(); ++i) {
    if (!(norm(loop[(i + 1) % loop.size()] - loop[i]) > 1e-9)) continue;
    wide.points.push_back(loop[i]);
    wide.widths.push_back(allowance.edge_widths.empty() ? allowance.width
                                                        : allowance.edge_widths[k][i]);
    wide.folds.push_back(!allowance.folds.empty() && allowance.folds[k][i] != 0);
  }
  return wide;
}

/// Whether the other side of a slit touches a vertex of an edge.
bool is_touched(const WideLoop& wide, std::size_t vertex, std::size_t edge, double near) {
  const Vec2 place = wide.points[vertex], along = wide.direction(edge);
  for (std::size_t k = 0; k < wide.points.size(); ++k) {
    if (k == vertex || k == wide.last(vertex)) continue;
    if (distance_to_segment(place, wide.points[k], wide.points[wide.next(k)]) > near) continue;
    if (are_opposite(along, wide.direction(k))) return true;
  }
  return false;
}

/// Sides of a slit that touch would be joined: those without an allowance are moved apart, by some
/// steps of the grid of winding_union().
WideLoop with_bare_sides_apart(const WideLoop& wide) {
  constexpr double k_apart = 3e-5;  // millimetres, either side
  WideLoop apart = wide;
  for (std::size_t i = 0; i < wide.points.size(); ++i) {
    Vec2 inwards;
    for (const std::size_t edge : {wide.last(i), i}) {
      if (wide.widths[edge] > 0.0) continue;
      if (is_touched(wide, i, edge, k_apart)) inwards = inwards - outwards(wide.direction(edge));
    }
    if (norm(inwards) > 0.5) apart.points[i] = wide.points[i] + k_apart / norm(inwards) * inwards;
  }
  return apart;
}

/// Whether the outline turns from one point to another one also when seen from as far off as the
/// allowance is wide. The points may be the same.
bool stands_out(const WideLoop& wide, const BorderWalk& walk, std::size_t first, std::size_t last,
                double turn) {
  const double width =
      std::max(wide.widths[last], wide.widths[first == 0 ? wide.widths.size() - 1 : first - 1]);
  const double far = std::min(width, 0.25 * walk.length());
  const Vec2 before = direction(walk.at(walk.way_to(first) - far), wide.points[first]);
  const Vec2 after = direction(wide.points[last], walk.at(walk.way_to(last) + far));
  return turn_between(before, after) >= 0.5 * turn;
}

/// How the allowances of the edges at a point are to be joined.
OutlineCorner corner_at(const WideLoop& wide, const BorderWalk& walk, std::size_t i,
                        const Allowance& allowance) {
  OutlineCorner corner = wide.corner(i, allowance.corners, allowance.mitre_limit);
  const double turn = turn_between(corner.before, corner.after);
  if (turn > 0.0 && !stands_out(wide, walk, i, i, turn)) corner.corners = Corners::round;
  return corner;
}

/// The raw offset line: it crosses itself wherever the outline is curved inwards. Where allowances
/// end beside an edge without, it is the outline.
Polygon raw_line(const WideLoop& wide, const BareEnds& ends, const Allowance& allowance) {
  const BorderWalk walk(wide.points);
  Polygon line;
  line.reserve(4 * wide.points.size());
  for (std::size_t i = 0; i < wide.points.size(); ++i) {
    const OutlineCorner corner = corner_at(wide, walk, i, allowance);
    if (!ends.is_at(i)) {
      append_join(corner, line);
      continue;
    }
    if (ends.of_edge[wide.last(i)].empty())
      line.push_back(corner.point + corner.width_before * outwards(corner.before));
    line.push_back(corner.point);
    if (ends.of_edge[i].empty())
      line.push_back(corner.point + corner.width_after * outwards(corner.after));
  }
  return line;
}

/// What the raw line lacks where allowances end: joins and stretches as far as the line that ends
/// them, counter-clockwise each.
void append_ends(const WideLoop& wide, const BareEnds& ends, const Allowance& allowance,
                 std::vector<Polygon>& lines) {
  const BorderWalk walk(wide.points);
  const auto append = [&](Polygon area, std::span<const EndLine> bounds) {
    area = left_of(std::move(area), bounds);
    if (signed_area(area) > 0.0) lines.push_back(std::move(area));
  };
  for (std::size_t i = 0; i < wide.points.size(); ++i) {
    if (ends.is_at(i)) {
      Polygon join = {wide.points[i]};
      append_join(ends.corners[i].value_or(corner_at(wide, walk, i, allowance)), join);
      append(std::move(join), ends.of_join[i]);
    }
    if (ends.of_edge[i].empty()) continue;
    const Vec2 a = wide.points[i], b = wide.points[wide.next(i)];
    const Vec2 out = wide.widths[i] * outwards(wide.direction(i));
    append({a, a + out, b + out, b}, ends.of_edge[i]);
  }
}

/// Where two lines meet, given by a point and a direction each; nothing where they are parallel.
std::optional<Vec2> meeting_point(Vec2 a, Vec2 along_a, Vec2 b, Vec2 along_b) {
  const double sine = cross(along_a, along_b);
  if (!(std::abs(sine) > 1e-6)) return std::nullopt;
  return a + cross(b - a, along_b) / sine * along_a;
}

/// What mitres lack at a corner that one or two short edges cut off: the area between the corner
/// and where the offset lines of the edges beside it meet, counter-clockwise. Empty where there is
/// no such corner from this point on.
/// @param edges how many cut it off
Polygon area_of_blunt_corner(const WideLoop& wide, const BorderWalk& walk, std::size_t first,
                             std::size_t edges, const Allowance& allowance) {
  constexpr double k_short = 0.5;  // of the allowance: all edges
  constexpr double k_least_turn = std::numbers::pi / 4.0, k_most_turn = 0.9 * std::numbers::pi;
  // Of the turn, at either end: with less the other end is the corner by itself.
  constexpr double k_least_part = 0.1;
  const std::size_t count = wide.points.size(), last = (first + edges) % count;
  const double width = wide.widths[first];
  const Vec2 before = direction(wide.points[(first + count - 1) % count], wide.points[first]);
  const Vec2 after = direction(wide.points[last], wide.points[(last + 1) % count]);
  double length = 0.0, turned = 0.0, turn_of_first = 0.0, turn_of_last = 0.0;
  Vec2 along = before;
  for (std::size_t k = 0; k <= edges; ++k) {
    const std::size_t at = (first + k) % count, next = (at + 1) % count;
    const Vec2 way = direction(wide.points[at], wide.points[next]);
    const double turn = turn_between(along, way);
    if (!(turn > 0.0) || wide.widths[at] != width) return {};
    turned += turn;
    if (k == 0) turn_of_first = turn;
    turn_of_last = turn;
    if (k < edges) length += norm(wide.points[next] - wide.points[at]);
    along = way;
  }
  if (wide.widths[(first + count - 1) % count] != width || length > k_short * width) return {};
  if (turned < k_least_turn || turned > k_most_turn) return {};
  if (std::min(turn_of_first, turn_of_last) < k_least_part * turned) return {};
  if (!stands_out(wide, walk, first, last, turned)) return {};
  const Vec2 from = wide.points[first] + width * outwards(before);
  const Vec2 to = wide.points[last] + width * outwards(after);
  const auto tip = meeting_point(from, before, to, after);
  const Vec2 middle = 0.5 * (wide.points[first] + wide.points[last]);
  if (!tip || norm(*tip - middle) > allowance.mitre_limit * width) return {};
  Polygon area = {wide.points[first], from, *tip, to};
  for (std::size_t k = edges + 1; k-- > 1;)
    area.push_back(wide.points[(first + k) % count]);
  return area;
}

/// What mitres lack at a corner: the vertices of the outline that cut it off, and the area.
struct BluntCorner {
  std::vector<std::size_t> vertices;
  Polygon area;
};

std::vector<BluntCorner> blunt_corners(const WideLoop& wide, const BareEnds& ends,
                                       std::size_t edges, const Allowance& allowance) {
  const BorderWalk walk(wide.points);
  std::vector<BluntCorner> corners;
  for (std::size_t i = 0; i < wide.points.size(); ++i) {
    Polygon area = area_of_blunt_corner(wide, walk, i, edges, allowance);
    for (std::size_t k = 0; k <= edges; ++k)
      area = left_of(std::move(area), ends.of_join[(i + k) % wide.points.size()]);
    if (area.empty() || !(signed_area(area) > 0.0)) continue;
    BluntCorner& corner = corners.emplace_back(BluntCorner{{}, std::move(area)});
    for (std::size_t k = 0; k <= edges; ++k)
      corner.vertices.push_back((i + k) % wide.points.size());
  }
  return corners;
}

/// A corner of a mesh is often cut off by an edge or two; mitres of each alone would leave a
/// chipped corner. Areas that are counter-clockwise may be added to the raw line: docs/pattern.md.
/// Two areas at one vertex would leave a notch between their tips, so neither is added; of two
/// edges and one of them, that of both is.
void append_blunt_corners(const WideLoop& wide, const BareEnds& ends, const Allowance& allowance,
                          std::vector<Polygon>& lines) {
  if (allowance.corners != Corners::mitre || wide.points.size() < 4) return;
  std::vector<int> areas_at(wide.points.size(), 0);
  const auto count = [&](const BluntCorner& corner) {
    for (const std::size_t v : corner.vertices)
      ++areas_at[v];
  };
  const auto most_at = [&](const BluntCorner& corner) {
    int most = 0;
    for (const std::size_t v : corner.vertices)
      most = std::max(most, areas_at[v]);
    return most;
  };
  std::vector<BluntCorner> corners = blunt_corners(wide, ends, 2, allowance);
  std::for_each(corners.begin(), corners.end(), count);
  std::vector<BluntCorner> of_one_edge = blunt_corners(wide, ends, 1, allowance);
  std::erase_if(of_one_edge, [&](const BluntCorner& corner) { return most_at(corner) > 0; });
  std::for_each(of_one_edge.begin(), of_one_edge.end(), count);
  std::move(of_one_edge.begin(), of_one_edge.end(), std::back_inserter(corners));
  for (BluntCorner& corner : corners) {
    if (most_at(corner) == 1) lines.push_back(std::move(corner.area));
  }
}

Vec2 middle_of(std::span<const Vec2> loop) {
  Vec2 sum;
  for (const Vec2 p : loop)
    sum = sum + p;
  return 1.0 / static_cast<double>(loop.size()) * sum;
}

bool has_width(const Allowance& allowance, std::size_t loop) {
  if (allowance.edge_widths.empty()) return true;
  const std::vector<double>& widths = allowance.edge_widths[loop];
  return std::any_of(widths.begin(), widths.end(), [](double width) { return width > 0.0; });
}

void check_holes(const PieceOutline& outline, const Allowance& allowance,
                 const std::vector<Polygon>& result) {
  for (std::size_t k = 1; k < outline.loops.size(); ++k) {
    if (!has_width(allowance, k)) continue;
    const auto is_left = [&](const Polygon& loop) {
      return signed_area(loop) < 0.0 && is_within(std::span(&outline.loops[k], 1), loop.front());
    };
    if (std::any_of(result.begin(), result.end(), is_left)) continue;
    const Vec2 middle = middle_of(outline.loops[k]);
    throw Error(ErrorCode::allowance_too_wide,
                about(outline) + "the seam allowance fills hole " + std::to_string(k) +
                    ", around (" + length_text(middle.x, 1) + ", " + length_text(middle.y, 1) +
                    ") mm; take less, or none for holes",
                {.path = {}, .first = k});
  }
}

}  // namespace

std::string_view to_string(Corners corners) {
  switch (corners) {
    case Corners::mitre:
      return "mitre";
    case Corners::square:
      return "square";
    case Corners::round:
      return "round";
  }
  return "unknown";
}

std::vector<Polygon> offset_outline(const PieceOutline& whole, const Allowance& asked) {
  check(whole, asked);
  const PieceOutline outline = with_straight_darts(with_straight_hems(whole, asked), asked.darts);
  const Allowance allowance = without_darts(outline, without_hems(asked));
  // Holes without an allowance are kept as they are, whatever reaches them from the outside.
  const std::size_t widened = allowance.holes ? outline.loops.size() : 1;
  std::vector<Polygon> lines;
  lines.reserve(widened);
  for (std::size_t k = 0; k < widened; ++k) {
    const WideLoop wide = with_bare_sides_apart(wide_loop(outline, k, allowance));
    const BareEnds ends = bare_ends(wide, allowance.corners, allowance.mitre_limit);
    lines.push_back(raw_line(wide, ends, allowance));
    append_ends(wide, ends, allowance, lines);
    append_blunt_corners(wide, ends, allowance, lines);
  }
  std::vector<Polygon> result = winding_union(lines);
  if (allowance.holes) check_holes(outline, allowance, result);
  if (!asked.hems.empty()) result = with_hems(outline, asked, std::move(result));
  if (!asked.darts.empty()) result = with_darts(outline, asked.darts, std::move(result));
  result.insert(result.end(), outline.loops.begin() + static_cast<std::ptrdiff_t>(widened),
                outline.loops.end());
  return result;
}

}  // namespace planish
