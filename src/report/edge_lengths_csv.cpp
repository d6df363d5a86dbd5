#include <cstddef>
#include <string>
#include <vector>

#include <planish/pattern/piece_outline.h>
#include <planish/report/json_report.h>

#include "core/number_text.h"

namespace planish {

std::string edge_lengths_csv(const Patch& patch, std::span<const Vec2> pattern, Unit unit) {
  const double scale = millimetres_per(unit);
  const PieceOutline outline =
      piece_outline(patch.border_loops(), in_millimetres(pattern, unit), "");
  std::string csv = "loop,from_vertex,to_vertex,length,length_on_model\n";
  for (const OutlineEdge& edge : edges_between_corners(outline)) {
    const std::vector<Index>& vertices = outline.vertices[edge.loop];
    double on_model = 0.0;
    for (std::size_t k = 1; k < edge.points.size(); ++k) {
      const Vec3 a = patch.positions()[vertices[edge.points[k - 1]]];
      on_model += scale * norm(patch.positions()[vertices[edge.points[k]]] - a);
    }
    csv += std::to_string(edge.loop) + ',' + std::to_string(vertices[edge.points.front()]) + ',' +
           std::to_string(vertices[edge.points.back()]) + ',' + fixed_text(edge.length, 3) + ',' +
           fixed_text(on_model, 3) + '\n';
  }
  return csv;
}

}  // namespace planish
