#include "mesh/coarsen/coarse_sizes.h"

#include <cmath>
#include <limits>
#include <numbers>

#include "mesh/coarsen/vertex_queue.h"

namespace planish {

namespace {

constexpr double k_no_size = std::numeric_limits<double>::infinity();
// Growth of the edge length by distance. Twice the slope of what makes good triangles is a bound
// for those that are tolerable.
constexpr double k_steepest = 0.5;
constexpr double k_typical = 0.35;
constexpr double k_area_per_vertex = std::numbers::sqrt3 / 2.0;  // at edge length 1

/// Size at the fixed edge that rules a vertex, and the way from there.
struct Origin {
  double size = k_no_size, distance = 0.0;
  double grown(double slope) const { return size + slope * distance; }
};

/// The mean length of the edges from v to other fixed vertices; k_no_size without any.
double fixed_size(const FineSurface& surface, const HalfEdges& half_edges,
                  std::span<const unsigned char> fixed, Index v) {
  double sum = 0.0, count = 0.0;
  half_edges.for_each_neighbor(v, [&](Index w) {
    const bool on_border = half_edges.is_border(v) && half_edges.is_border(w);
    const bool chord =
        on_border && half_edges.next_on_border(v) != w && half_edges.next_on_border(w) != v;
    if (fixed[w] == 0 || chord) return;
    sum += norm(surface.positions[w] - surface.positions[v]);
    ++count;
  });
  return count > 0.0 ? sum / count : k_no_size;
}

/// For each vertex the origin that gives it the least size at the typical slope.
std::vector<Origin> find_origins(const FineSurface& surface, const HalfEdges& half_edges,
                                 std::span<const unsigned char> fixed) {
  std::vector<Origin> origins(fixed.size());
  VertexQueue<double> queue(fixed.size());
  for (Index v = 0; v < fixed.size(); ++v) {
    if (fixed[v] == 0 || !half_edges.is_used(v)) continue;
    origins[v].size = fixed_size(surface, half_edges, fixed, v);
    if (origins[v].size < k_no_size) queue.set(v, origins[v].size);
  }
  while (!queue.empty()) {
    const Index v = queue.top();
    queue.remove(v);
    half_edges.for_each_neighbor(v, [&](Index w) {
      const double length = norm(surface.positions[w] - surface.positions[v]);
      const Origin through_v{origins[v].size, origins[v].distance + length};
      if (!(through_v.grown(k_typical) < origins[w].grown(k_typical))) return;
      origins[w] = through_v;
      queue.set(w, through_v.grown(k_typical));
    });
  }
  return origins;
}

/// How many vertices triangles of the sizes have.
double count_at(double slope, const FineSurface& surface, const std::vector<Origin>& origins,
                std::span<const unsigned char> fixed) {
  double count = 0.0;
  for (std::size_t v = 0; v < origins.size(); ++v) {
    const double size = origins[v].grown(slope);
    const double share = surface.areas[v] / (k_area_per_vertex * size * size);
    count += fixed[v] != 0 ? 0.5 : share < 1.0 ? share : 1.0;
  }
  return count;
}

}  // namespace

std::vector<double> even_sizes(const FineSurface& surface, std::size_t vertices) {
  double area = 0.0;
  for (const double a : surface.areas)
    area += a;
  const double size =
      std::sqrt(area / (k_area_per_vertex * static_cast<double>(vertices > 0 ? vertices : 1)));
  return std::vector<double>(surface.areas.size(), size > 0.0 ? size : 1.0);
}

std::vector<double> graded_sizes(const FineSurface& surface, const HalfEdges& half_edges,
                                 std::span<const unsigned char> fixed, std::size_t vertices) {
  const auto origins = find_origins(surface, half_edges, fixed);
  double low = 0.0, high = k_steepest;
  for (int i = 0; i < 12; ++i) {
    const double middle = 0.5 * (low + high);
    const bool too_many = count_at(middle, surface, origins, fixed) > static_cast<double>(vertices);
    (too_many ? low : high) = middle;
  }
  auto sizes = even_sizes(surface, vertices);
  for (std::size_t v = 0; v < sizes.size(); ++v) {
    const double size = origins[v].grown(high);
    if (size > 0.0 && size < k_no_size) sizes[v] = size;
  }
  return sizes;
}

}  // namespace planish
