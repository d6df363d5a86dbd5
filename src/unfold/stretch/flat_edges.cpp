#include "unfold/stretch/flat_edges.h"

#include <algorithm>
#include <utility>

namespace planish {

std::vector<FlatEdge> flat_edges(const TriMesh& mesh, const Disk& disk) {
  std::vector<FlatEdge> sides;
  sides.reserve(3 * disk.triangles.size());
  for (std::size_t t = 0; t < disk.triangles.size(); ++t) {
    for (int k = 0; k < 3; ++k) {
      const auto [from, to] = std::minmax(disk.triangles[t][k], disk.triangles[t][(k + 1) % 3]);
      sides.push_back({from, to, 0.0, disk.rest[t].area() / 3.0});
    }
  }
  std::stable_sort(sides.begin(), sides.end(), [](const FlatEdge& a, const FlatEdge& b) {
    return std::pair(a.from, a.to) < std::pair(b.from, b.to);
  });

  std::vector<FlatEdge> edges;
  edges.reserve(sides.size() / 2 + disk.border.size());
  for (const FlatEdge& side : sides) {
    if (!edges.empty() && edges.back().from == side.from && edges.back().to == side.to) {
      edges.back().area += side.area;
      continue;
    }
    const Vec3 a = mesh.positions[disk.vertex_of[side.from]];
    const Vec3 b = mesh.positions[disk.vertex_of[side.to]];
    const double length = disk.area_scale * norm(disk.box_scale * b - disk.box_scale * a);
    edges.push_back({side.from, side.to, length, side.area});
  }
  return edges;
}

std::vector<double> strains_of(std::span<const FlatEdge> edges, const std::vector<Vec2>& flat) {
  std::vector<double> strains;
  strains.reserve(edges.size());
  for (const FlatEdge& edge : edges)
    strains.push_back(LaidEdge(edge, flat).strain);
  return strains;
}

std::vector<StrainOfEdge> with_areas(std::span<const FlatEdge> edges,
                                     std::span<const double> strains) {
  std::vector<StrainOfEdge> weighed;
  weighed.reserve(edges.size());
  for (std::size_t e = 0; e < edges.size(); ++e)
    weighed.push_back({strains[e], edges[e].area});
  return weighed;
}

}  // namespace planish
