#include "mesh/coarsen/fine_surface.h"

#include "geometry/box.h"

namespace planish {

namespace {

// How many times as much a square of the distance to the border counts as one to the surface.
constexpr double k_border_stress = 4.0;

std::vector<Vec3> scaled_positions(const TriMesh& mesh) {
  Box box;
  for (const Triangle& t : mesh.triangles) {
    for (const Index v : t)
      box.add(mesh.positions[v]);
  }
  const double scale = unit_scale(box);
  const Vec3 middle = 0.5 * (scale * box.low) + 0.5 * (scale * box.high);
  std::vector<Vec3> positions;
  positions.reserve(mesh.positions.size());
  for (const Vec3 p : mesh.positions)
    positions.push_back(scale * p - middle);
  return positions;
}

void add_triangles(const TriMesh& mesh, FineSurface& surface) {
  for (const Triangle& t : mesh.triangles) {
    const Vec3 p = surface.positions[t[0]];
    const Vec3 n = cross(surface.positions[t[1]] - p, surface.positions[t[2]] - p);
    const double length = norm(n);
    if (!(length > 0.0)) continue;
    for (const Index v : t) {
      surface.normals[v] += n;
      surface.areas[v] += length / 6.0;
      surface.quadrics[v].add_plane(p, (1.0 / length) * n, length / 6.0);
    }
  }
}

void add_border(const HalfEdges& half_edges, FineSurface& surface) {
  for (Index h = 0; h < half_edges.size(); ++h) {
    if (half_edges.twin(h) != HalfEdges::none) continue;
    const Index v = half_edges.from(h), w = half_edges.to(h);
    const Vec3 p = surface.positions[v], edge = surface.positions[w] - p;
    const double length = norm(edge);
    if (!(length > 0.0)) continue;
    for (const Index end : {v, w})
      surface.quadrics[end].add_line(p, (1.0 / length) * edge, length * length, k_border_stress);
  }
}

}  // namespace

FineSurface fine_surface(const TriMesh& mesh, const HalfEdges& half_edges) {
  const std::size_t n = mesh.positions.size();
  FineSurface surface;
  surface.positions = scaled_positions(mesh);
  surface.normals.assign(n, Vec3{});
  surface.areas.assign(n, 0.0);
  surface.quadrics.assign(n, PlaneQuadric{});
  add_triangles(mesh, surface);
  add_border(half_edges, surface);
  for (Vec3& normal : surface.normals) {
    const double length = norm(normal);
    if (length > 0.0) normal = (1.0 / length) * normal;
  }
  return surface;
}

}  // namespace planish
