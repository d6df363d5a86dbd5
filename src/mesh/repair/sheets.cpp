#include "mesh/repair/sheets.h"

#include "mesh/disjoint_sets.h"

namespace planish {

namespace {

/// @param first_of of each triangle the smallest number of its set; sets come by their first ones
template <class FirstOf>
Sheets numbered(std::size_t triangles, std::size_t sets, const FirstOf& first_of) {
  constexpr Index none = static_cast<Index>(-1);
  Sheets sheets{std::vector<Index>(triangles), 0};
  std::vector<Index> number(sets, none);
  for (std::size_t i = 0; i < triangles; ++i) {
    Index& of_set = number[first_of(static_cast<Index>(i))];
    if (of_set == none) of_set = static_cast<Index>(sheets.count++);
    sheets.of_triangle[i] = of_set;
  }
  return sheets;
}

}  // namespace

Sheets find_sheets(std::size_t triangles, const std::vector<EdgeSides>& edges, std::size_t most) {
  DisjointSets<Index> sets(triangles);
  for (const EdgeSides& edge : edges) {
    if (most != 0 && edge.size() > most) continue;
    for (const EdgeSide* side = edge.begin + 1; side < edge.end; ++side)
      sets.join(edge.begin->triangle, side->triangle);
  }
  return numbered(triangles, triangles, [&](Index t) { return sets.first_of(t); });
}

Sheets find_sheets(const TriMesh& mesh) {
  const std::vector<EdgeSide> sides = sorted_sides(mesh);
  return find_sheets(mesh.triangles.size(), group_by_edge(sides));
}

Sheets find_parts_by_vertices(const TriMesh& mesh) {
  DisjointSets<Index> sets(mesh.positions.size());
  for (const Triangle& t : mesh.triangles) {
    sets.join(t[0], t[1]);
    sets.join(t[0], t[2]);
  }
  return numbered(mesh.triangles.size(), mesh.positions.size(),
                  [&](Index t) { return sets.first_of(mesh.triangles[t][0]); });
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
