#include <cstddef>
#include <string>
#include <vector>

#include <planish/pattern/piece_outline.h>
#include <planish/report/json_report.h>

#include "core/number_text.h"

namespace planish {

std::string edge_lengths_csv(const Patch& patch, std::span<const Vec2> pattern, Unit unit,
                             const PatternOptions& options) {
  const double of_sheet = millimetres_per(options.sheet_unit);
  const std::string suffix =
      options.sheet_unit == Unit::mm ? "" : "_" + std::string(to_string(options.sheet_unit));
  const int decimals = options.sheet_unit == Unit::mm ? 3 : 4;
  const double scale = millimetres_per(unit);
  const PieceOutline outline =
      piece_outline(patch.border_loops(), in_millimetres(pattern, unit), "");
  std::string csv = "loop,from_vertex,to_vertex,length" + suffix + ",length_on_model" + suffix +
                    (options.edges.empty() ? "\n" : ",edge\n");
  const std::vector<std::string> names = words_of_edges(outline, options.edges);
  const std::vector<OutlineEdge> edges = edges_between_corners(outline);
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const OutlineEdge& edge = edges[e];
    const std::vector<Index>& vertices = outline.vertices[edge.loop];
    double on_model = 0.0;
    for (std::size_t k = 1; k < edge.points.size(); ++k) {
      const Vec3 a = patch.positions()[vertices[edge.points[k - 1]]];
      on_model += scale * norm(patch.positions()[vertices[edge.points[k]]] - a);
    }
    csv += std::to_string(edge.loop) + ',' + std::to_string(vertices[edge.points.front()]) + ',' +
           std::to_string(vertices[edge.points.back()]) + ',' +
           fixed_text(edge.length / of_sheet, decimals) + ',' +
           fixed_text(on_model / of_sheet, decimals) +
           (options.edges.empty() ? "" : "," + names[e]) + '\n';
  }
  return csv;
}

}  // namespace planish
