#include "pattern/filled_slit.h"

#include <cstddef>
#include <utility>
#include <vector>

#include "pattern/polygon/plane.h"
#include "pattern/polygon/polygon_edges.h"

namespace planish {

namespace {

/// Whether places are farther from edges than a bound. A search begins at the edge that ended the
/// last one: of places that follow each other, nearly all need one or two.
class FartherThan {
 public:
  FartherThan(std::vector<PolygonEdge> edges, double bound)
      : edges_(std::move(edges)), bound_(bound) {}

  bool operator()(Vec2 place) {
    for (std::size_t k = 0; k < edges_.size(); ++k) {
      const std::size_t at = (begin_ + k) % edges_.size();
      if (distance_to_segment(place, edges_[at].a, edges_[at].b) > bound_) continue;
      begin_ = at;
      return false;
    }
    return true;
  }

 private:
  std::vector<PolygonEdge> edges_;
  double bound_;
  std::size_t begin_ = 0;
};

}  // namespace

std::vector<OutlineStretch> filled_slits(std::span<const Polygon> outline,
                                         std::span<const Polygon> cut, double width) {
  FartherThan is_far(polygon_edges(cut), 2.0 * width);
  std::vector<OutlineStretch> stretches;
  for (std::size_t l = 0; l < outline.size(); ++l) {
    const Polygon& loop = outline[l];
    std::vector<double> filled;  // the length of each edge, 0 of those with a cut line
    filled.reserve(loop.size());
    for (const PolygonEdge& edge : polygon_edges({&loop, 1}))
      filled.push_back(is_far(edge.a) && is_far(edge.b) ? norm(edge.b - edge.a) : 0.0);
    const std::size_t count = loop.size();
    for (std::size_t i = 0; i < count; ++i) {
      if (!(filled[i] > 0.0) || filled[(i + count - 1) % count] > 0.0) continue;
      OutlineStretch stretch = {l, i, 0.0};
      std::size_t edges = 0;
      for (; edges < count && filled[(i + edges) % count] > 0.0; ++edges)
        stretch.length += filled[(i + edges) % count];
      stretch.middle = (i + (edges + 1) / 2) % count;
      stretches.push_back(stretch);
    }
  }
  return stretches;
}

}  // namespace planish
