#include "report/placed_pattern.h"

#include <cstddef>

#include "report/outlines.h"

namespace planish {

PlacedPattern placed_pattern(const TriMesh& mesh, std::span<const Vec2> positions, Unit unit,
                             const std::string& piece, const PatternOptions& options) {
  const double scale = millimetres_per(unit);
  PlacedPattern pattern;
  pattern.positions.reserve(positions.size());
  for (const Vec2 p : positions)
    pattern.positions.push_back(scale * p);
  const std::vector<HalfEdge> opposite = opposite_half_edges(mesh);
  pattern.outline = piece_outline(outlines(mesh, opposite, [](std::size_t) { return true; }),
                                  pattern.positions, piece);
  pattern.cut = pattern.outline.loops;
  if (options.allowance) {
    pattern.cut = offset_outline(
        pattern.outline,
        with_edge_allowances(*options.allowance, pattern.outline, options.edge_allowances));
  }
  return pattern;
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
