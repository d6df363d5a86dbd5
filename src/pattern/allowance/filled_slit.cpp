#include "pattern/allowance/filled_slit.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "pattern/polygon/plane.h"
#include "pattern/polygon/polygon_edges.h"
#include "pattern/polygon/polygon_rays.h"

namespace planish {

namespace {

constexpr double k_touching = 1e-3;  // millimetres: sides of a slit without a gap

/// What tells of places of an outline whether they have a cut line.
class Slits {
 public:
  Slits(std::span<const Polygon> outline, std::span<const Polygon> cut, double width)
      : edges_(polygon_edges(outline)), cut_(cut), cut_edges_(polygon_edges(cut)), width_(width) {}

  /// The length of an edge that the other side of a slit faces, with no cut line between them.
  double filled_length(const PolygonEdge& edge) const {
    const double length = norm(edge.b - edge.a);
    if (!(length > 0.0)) return 0.0;
    const double parts = std::clamp(std::ceil(2.0 * length / width_), 1.0, 64.0);
    double filled = 0.0;
    for (double k = 0.5; k < parts; k += 1.0) {
      if (is_filled(edge.a + k / parts * (edge.b - edge.a), 1.0 / length * (edge.b - edge.a)))
        filled += 1.0;
    }
    return filled / parts * length;
  }

  /// Whether a place has no cut line beside it, as those at the end of a filled slit.
  bool is_far_inside(Vec2 place) const {
    const double far = 1.01 * width_;
    return std::all_of(cut_edges_.begin(), cut_edges_.end(), [&](const PolygonEdge& edge) {
      return distance_to_segment(place, edge.a, edge.b) > far;
    });
  }

 private:
  bool is_filled(Vec2 place, Vec2 along) const {
    const Vec2 out = {along.y, -along.x};
    const double gap = gap_to_other_side(place, along, out);
    return gap <= 2.0 * width_ && first_hit(cut_, place, out, -k_touching) > gap + k_touching;
  }

  double gap_to_other_side(Vec2 place, Vec2 along, Vec2 out) const {
    double gap = k_no_hit;
    for (const PolygonEdge& edge : edges_) {
      const Vec2 a = edge.a - place, b = edge.b - place;
      const double left = cross(out, a), right = cross(out, b);
      if ((left >= 0.0) == (right >= 0.0)) continue;
      const Vec2 other = edge.b - edge.a;
      if (!are_opposite(along, other)) continue;
      const double distance = dot(a + left / (left - right) * other, out);
      if (distance >= -k_touching) gap = std::min(gap, distance);
    }
    return gap;
  }

  std::vector<PolygonEdge> edges_;
  std::span<const Polygon> cut_;
  std::vector<PolygonEdge> cut_edges_;
  double width_;
};

/// Adds the ends of slits, which face nothing: the few edges between two filled ones.
void add_ends(const std::vector<PolygonEdge>& edges, const Slits& slits, double width,
              std::vector<double>& filled) {
  const std::size_t count = edges.size();
  for (std::size_t i = 0; i < count; ++i) {
    if (!(filled[i] > 0.0)) continue;
    double length = 0.0;
    std::size_t next = 1;
    for (; next < count && !(filled[(i + next) % count] > 0.0); ++next) {
      const PolygonEdge& edge = edges[(i + next) % count];
      length += norm(edge.b - edge.a);
      if (length > 4.0 * width || !slits.is_far_inside(0.5 * (edge.a + edge.b))) break;
    }
    if (next == count || !(filled[(i + next) % count] > 0.0)) continue;
    for (std::size_t k = 1; k < next; ++k) {
      const PolygonEdge& edge = edges[(i + k) % count];
      filled[(i + k) % count] = norm(edge.b - edge.a);
    }
  }
}

}  // namespace

std::vector<OutlineStretch> filled_slits(std::span<const Polygon> outline,
                                         std::span<const Polygon> cut, double width) {
  const Slits slits(outline, cut, width);
  std::vector<OutlineStretch> stretches;
  for (std::size_t l = 0; l < outline.size(); ++l) {
    const std::vector<PolygonEdge> edges = polygon_edges(outline.subspan(l, 1));
    const std::size_t count = edges.size();
    std::vector<double> filled;  // the length of each edge, 0 of those with a cut line
    filled.reserve(count);
    for (const PolygonEdge& edge : edges)
      filled.push_back(slits.filled_length(edge));
    add_ends(edges, slits, width, filled);
    for (std::size_t i = 0; i < count; ++i) {
      if (!(filled[i] > 0.0) || filled[(i + count - 1) % count] > 0.0) continue;
      OutlineStretch stretch = {l, i, 0.0};
      std::size_t run = 0;
      for (; run < count && filled[(i + run) % count] > 0.0; ++run)
        stretch.length += filled[(i + run) % count];
      stretch.middle = (i + (run + 1) / 2) % count;
      stretches.push_back(stretch);
    }
  }
  return stretches;
}

}  // namespace planish
