#include "sheet/placed_pattern.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "sheet/outlines.h"

namespace planish {

namespace {

std::vector<Vec2> scaled(std::span<const Vec2> positions, double scale, bool mirrored) {
  std::vector<Vec2> places;
  places.reserve(positions.size());
  for (const Vec2 p : positions)
    places.push_back(scale * (mirrored ? Vec2{0.0 - p.x, p.y} : p));
  return places;
}

std::vector<std::vector<Index>> border_loops(const TriMesh& mesh, bool reversed) {
  const std::vector<HalfEdge> opposite = opposite_half_edges(mesh);
  auto loops = outlines(mesh, opposite, [](std::size_t) { return true; });
  for (auto& loop : loops) {
    if (reversed) std::reverse(loop.begin(), loop.end());
  }
  return loops;
}

void begin_at(Index start, PieceOutline& outline) {
  for (std::size_t k = 0; k < outline.vertices.size(); ++k) {
    auto& loop = outline.vertices[k];
    const auto found = std::find(loop.begin(), loop.end(), start);
    if (found == loop.end()) continue;
    std::rotate(outline.loops[k].begin(), outline.loops[k].begin() + (found - loop.begin()),
                outline.loops[k].end());
    std::rotate(loop.begin(), found, loop.end());
  }
}

std::vector<EdgeAllowance> turned_round(std::vector<EdgeAllowance> edges) {
  for (EdgeAllowance& edge : edges)
    std::swap(edge.from, edge.to);
  return edges;
}

/// The mirror image in the line x = 0, every line beginning at the same point.
PlacedPattern mirror_image(PlacedPattern pattern) {
  pattern = moved(std::move(pattern), [](Vec2 p) { return Vec2{0.0 - p.x, p.y}; });
  const auto reverse = [](auto& loops) {
    for (auto& loop : loops) {
      if (!loop.empty()) std::reverse(loop.begin() + 1, loop.end());
    }
  };
  reverse(pattern.outline.loops);
  reverse(pattern.outline.vertices);
  reverse(pattern.cut);
  return pattern;
}

}  // namespace

PlacedPattern placed_pattern(const TriMesh& mesh, std::span<const Vec2> positions, Unit unit,
                             const std::string& piece, const PatternOptions& options) {
  // Of a mirrored pattern the one that it was made from is placed, so that rounding is the same.
  const bool mirrored = options.like && options.like->mirrored;
  PlacedPattern pattern;
  pattern.positions = scaled(positions, millimetres_per(unit), mirrored);
  pattern.outline = piece_outline(border_loops(mesh, mirrored), pattern.positions, piece);
  if (options.like) begin_at(options.like->start, pattern.outline);
  pattern.cut = pattern.outline.loops;
  if (options.allowance) {
    const std::vector<EdgeAllowance> edges =
        mirrored ? turned_round(options.edge_allowances) : options.edge_allowances;
    pattern.cut = offset_outline(pattern.outline,
                                 with_edge_allowances(*options.allowance, pattern.outline, edges));
  }
  return mirrored ? mirror_image(std::move(pattern)) : pattern;
}

PlacedPattern moved(PlacedPattern pattern, const std::function<Vec2(Vec2)>& motion) {
  const auto move = [&](std::vector<Vec2>& points) {
    for (Vec2& p : points)
      p = motion(p);
  };
  for (Polygon& loop : pattern.outline.loops)
    move(loop);
  for (Polygon& loop : pattern.cut)
    move(loop);
  move(pattern.positions);
  return pattern;
}

}  // namespace planish
