#include <algorithm>
#include <utility>

#include <planish/pattern/piece_outline.h>

namespace planish {

double signed_area(std::span<const Vec2> loop) {
  double doubled = 0.0;
  for (std::size_t i = 1; i + 1 < loop.size(); ++i)
    doubled += cross(loop[i] - loop[0], loop[i + 1] - loop[0]);
  return 0.5 * doubled;
}

std::vector<Vec2> in_millimetres(std::span<const Vec2> positions, Unit unit) {
  std::vector<Vec2> scaled(positions.begin(), positions.end());
  for (Vec2& p : scaled)
    p = millimetres_per(unit) * p;
  return scaled;
}

PieceOutline piece_outline(std::vector<std::vector<Index>> loops, std::span<const Vec2> positions,
                           std::string piece) {
  PieceOutline outline{std::move(piece), {}, std::move(loops)};
  outline.loops.reserve(outline.vertices.size());
  for (auto& loop : outline.vertices) {
    std::rotate(loop.begin(), std::min_element(loop.begin(), loop.end()), loop.end());
    Polygon& points = outline.loops.emplace_back();
    points.reserve(loop.size());
    for (const Index v : loop)
      points.push_back(positions[v]);
  }
  for (std::size_t k = 1; k < outline.loops.size(); ++k) {
    if (signed_area(outline.loops[k]) <= signed_area(outline.loops[0])) continue;
    std::swap(outline.loops[0], outline.loops[k]);
    std::swap(outline.vertices[0], outline.vertices[k]);
  }
  return outline;
}

}  // namespace planish
