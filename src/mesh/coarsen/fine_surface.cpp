#include "mesh/coarsen/fine_surface.h"

#include <array>

#include "geometry/box.h"

namespace planish {

namespace {

// How many times as much a square of the distance to the border counts as one to the surface.
constexpr double k_border_stress = 4.0;

/// Calls f with the vertices of each triangle, a vector across it and the length of that, twice its
/// area; not with those that have no area.
template <class F>
void for_each_triangle(const ScaledPositions& positions, const HalfEdges& half_edges, F f) {
  for (Index h = 0; h < half_edges.size(); h += 3) {
    const std::array<Index, 3> t = {half_edges.from(h), half_edges.to(h), half_edges.apex(h)};
    const Vec3 p = positions[t[0]];
    const Vec3 n = cross(positions[t[1]] - p, positions[t[2]] - p);
    const double length = norm(n);
    if (length > 0.0) f(t, n, length);
  }
}

}  // namespace

ScaledPositions::ScaledPositions(const TriMesh& mesh, std::span<const Index> order)
    : positions_(mesh.positions), order_(order) {
  Box box;
  for (const Triangle& t : mesh.triangles) {
    for (const Index v : t)
      box.add(mesh.positions[v]);
  }
  scale_ = unit_scale(box);
  middle_ = 0.5 * (scale_ * box.low) + 0.5 * (scale_ * box.high);
}

FineSurface fine_surface(const ScaledPositions& positions, const HalfEdges& half_edges) {
  FineSurface surface{positions, std::vector<Vec3>(positions.size()),
                      std::vector<double>(positions.size(), 0.0)};
  for_each_triangle(positions, half_edges, [&](const auto& t, Vec3 n, double length) {
    for (const Index v : t) {
      surface.normals[v] += n;
      surface.areas[v] += length / 6.0;
    }
  });
  for (Vec3& normal : surface.normals) {
    const double length = norm(normal);
    if (length > 0.0) normal = (1.0 / length) * normal;
  }
  return surface;
}

std::vector<PlaneQuadric> fine_quadrics(const ScaledPositions& positions,
                                        const HalfEdges& half_edges) {
  std::vector<PlaneQuadric> quadrics(positions.size());
  for_each_triangle(positions, half_edges, [&](const auto& t, Vec3 n, double length) {
    for (const Index v : t)
      quadrics[v].add_plane(positions[t[0]], (1.0 / length) * n, length / 6.0);
  });
  for (Index h = 0; h < half_edges.size(); ++h) {
    if (half_edges.twin(h) != HalfEdges::none) continue;
    const Index v = half_edges.from(h), w = half_edges.to(h);
    const Vec3 p = positions[v], edge = positions[w] - p;
    const double length = norm(edge);
    if (!(length > 0.0)) continue;
    for (const Index end : {v, w})
      quadrics[end].add_line(p, (1.0 / length) * edge, length * length, k_border_stress);
  }
  return quadrics;
}

}  // namespace planish
