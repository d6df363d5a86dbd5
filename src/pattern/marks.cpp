#include <cstddef>
#include <numbers>
#include <string>

#include <planish/core/error.h>
#include <planish/pattern/marks.h>

#include "core/math.h"

namespace planish {

namespace {

void append_cross(Vec2 at, std::vector<Polygon>& lines) {
  const double half = 0.5 * k_cross_size;
  lines.push_back({{at.x - half, at.y}, {at.x + half, at.y}});
  lines.push_back({{at.x, at.y - half}, {at.x, at.y + half}});
}

Polygon ring(Vec2 at) {
  constexpr int corners = 24;
  Polygon line;
  line.reserve(corners + 1);
  for (int k = 0; k < corners; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / corners;
    line.push_back(at + 0.5 * k_drill_size * Vec2{math::cos(angle), math::sin(angle)});
  }
  line.push_back(line.front());
  return line;
}

void check_vertex(Index vertex, std::size_t vertex_count, std::string_view piece,
                  const std::string& what) {
  if (vertex < vertex_count) return;
  throw Error(ErrorCode::index_out_of_range,
              "piece \"" + std::string(piece) + "\": " + what + " vertex " +
                  std::to_string(vertex) + ", but there are " + std::to_string(vertex_count) +
                  ", counted from 0",
              {.path = {}, .first = vertex});
}

void check_place(const SurfacePoint& place, std::size_t vertex_count, std::string_view piece,
                 const std::string& what) {
  for (const Index corner : place.corners)
    check_vertex(corner, vertex_count, piece, what);
}

}  // namespace

std::string_view to_string(MarkKind kind) {
  return kind == MarkKind::cross ? "cross" : "drill";
}

Vec2 place_of(const Mark& mark, std::span<const Vec2> positions) {
  return mark.place ? position_of(*mark.place, positions) : positions[mark.vertex];
}

void check_marks(std::size_t vertex_count, std::span<const Mark> marks, std::string_view piece) {
  for (const Mark& mark : marks) {
    check_vertex(mark.vertex, vertex_count, piece, "a mark is at");
    if (mark.place) check_place(*mark.place, vertex_count, piece, "a mark is near");
  }
}

void check_inner_lines(std::size_t vertex_count, std::span<const InnerLine> lines,
                       std::string_view piece) {
  for (const InnerLine& line : lines) {
    for (const Index vertex : line)
      check_vertex(vertex, vertex_count, piece, "an inner line goes through");
  }
}

std::vector<Polygon> inner_lines(std::span<const Vec2> positions, std::span<const InnerLine> lines,
                                 std::string_view piece) {
  check_inner_lines(positions.size(), lines, piece);
  std::vector<Polygon> result;
  result.reserve(lines.size());
  for (const InnerLine& line : lines) {
    Polygon& points = result.emplace_back();
    points.reserve(line.size());
    for (const Index vertex : line)
      points.push_back(positions[vertex]);
  }
  return result;
}

void check_inner_lines(std::size_t vertex_count, std::span<const SurfaceLine> lines,
                       std::string_view piece) {
  for (const SurfaceLine& line : lines) {
    for (const SurfacePoint& place : line)
      check_place(place, vertex_count, piece, "an inner line goes near");
  }
}

std::vector<Polygon> inner_lines(std::span<const Vec2> positions,
                                 std::span<const SurfaceLine> lines, std::string_view piece) {
  check_inner_lines(positions.size(), lines, piece);
  std::vector<Polygon> result;
  result.reserve(lines.size());
  for (const SurfaceLine& line : lines) {
    Polygon& points = result.emplace_back();
    points.reserve(line.size());
    for (const SurfacePoint& place : line)
      points.push_back(position_of(place, positions));
  }
  return result;
}

std::vector<Polygon> mark_lines(std::span<const Vec2> positions, std::span<const Mark> marks,
                                std::string_view piece) {
  check_marks(positions.size(), marks, piece);
  std::vector<Polygon> lines;
  lines.reserve(2 * marks.size());
  for (const Mark& mark : marks) {
    const Vec2 at = place_of(mark, positions);
    if (mark.kind == MarkKind::cross) {
      append_cross(at, lines);
    } else {
      lines.push_back(ring(at));
    }
  }
  return lines;
}

}  // namespace planish
