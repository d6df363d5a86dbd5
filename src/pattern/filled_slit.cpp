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

double filled_slit_length(std::span<const Polygon> outline, std::span<const Polygon> cut,
                          double width) {
  FartherThan is_far(polygon_edges(cut), 2.0 * width);
  double length = 0.0;
  for (const PolygonEdge& edge : polygon_edges(outline)) {
    if (is_far(edge.a) && is_far(edge.b)) length += norm(edge.b - edge.a);
  }
  return length;
}

}  // namespace planish
