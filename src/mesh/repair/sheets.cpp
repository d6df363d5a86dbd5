#include "mesh/repair/sheets.h"

#include "mesh/disjoint_sets.h"

namespace planish {

Sheets find_sheets(std::size_t triangles, const std::vector<EdgeSides>& edges, std::size_t most) {
  DisjointSets<Index> sets(triangles);
  for (const EdgeSides& edge : edges) {
    if (most != 0 && edge.size() > most) continue;
    for (const EdgeSide* side = edge.begin + 1; side < edge.end; ++side)
      sets.join(edge.begin->triangle, side->triangle);
  }
  Sheets sheets{std::vector<Index>(triangles), 0};
  for (std::size_t i = 0; i < triangles; ++i) {
    const auto t = static_cast<Index>(i);
    const Index first = sets.first_of(t);
    sheets.of_triangle[t] =
        first == t ? static_cast<Index>(sheets.count++) : sheets.of_triangle[first];
  }
  return sheets;
}

Sheets find_sheets(const TriMesh& mesh) {
  const std::vector<EdgeSide> sides = sorted_sides(mesh);
  return find_sheets(mesh.triangles.size(), group_by_edge(sides));
}

std::vector<double> unit_areas(const TriMesh& mesh) {
  const double scale = unit_scale(mesh);
  std::vector<double> areas;
  areas.reserve(mesh.triangles.size());
  for (const Triangle& t : mesh.triangles) {
    const Vec3 at = scale * mesh.positions[t[0]];
    areas.push_back(
        0.5 * norm(cross(scale * mesh.positions[t[1]] - at, scale * mesh.positions[t[2]] - at)));
  }
  return areas;
}

std::vector<double> sums_over(const Sheets& sheets, const std::vector<double>& of_triangle) {
  std::vector<double> sums(sheets.count, 0.0);
  for (std::size_t t = 0; t < of_triangle.size(); ++t)
    sums[sheets.of_triangle[t]] += of_triangle[t];
  return sums;
}

}  // namespace planish
