#include "pattern/polygon/polygon_edges.h"

#include <cstddef>

namespace planish {

std::vector<PolygonEdge> polygon_edges(std::span<const Polygon> polygons) {
  std::vector<PolygonEdge> edges;
  for (const Polygon& polygon : polygons) {
    for (std::size_t i = 0; i < polygon.size(); ++i)
      edges.push_back({polygon[i], polygon[(i + 1) % polygon.size()]});
  }
  return edges;
}

}  // namespace planish
