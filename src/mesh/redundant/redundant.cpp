#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

#include <planish/mesh/patch.h>
#include <planish/mesh/repair.h>

#include "mesh/edge_sides.h"
#include "mesh/redundant/cells.h"
#include "mesh/redundant/doubled.h"
#include "mesh/repair/repaired.h"
#include "mesh/repair/sheets.h"

namespace planish {

namespace {

// A fin holds less of the area.
constexpr double k_fin = 0.01;

using Marks = std::vector<unsigned char>;

std::size_t mark_collapsed(const TriMesh& mesh, Marks& gone) {
  std::size_t count = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Triangle& tri = mesh.triangles[t];
    if (tri[0] != tri[1] && tri[1] != tri[2] && tri[2] != tri[0]) continue;
    gone[t] = 1;
    ++count;
  }
  return count;
}

/// The corners in their order, the smallest first.
Triangle turned_to_smallest(Triangle t) {
  std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  return t;
}

std::size_t mark_repeated(const TriMesh& mesh, Marks& gone) {
  std::vector<std::pair<Triangle, Index>> keys;
  keys.reserve(mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (gone[t] == 0)
      keys.emplace_back(turned_to_smallest(mesh.triangles[t]), static_cast<Index>(t));
  }
  std::sort(keys.begin(), keys.end());
  std::size_t count = 0;
  for (std::size_t i = 1; i < keys.size(); ++i) {
    if (keys[i].first != keys[i - 1].first) continue;
    gone[keys[i].second] = 1;
    ++count;
  }
  return count;
}

/// In a sound mesh no quadrilateral is there by both of its diagonals in the same orientation.
std::size_t mark_other_diagonals(const TriMesh& mesh, Marks& gone) {
  const std::vector<EdgeSide> sides = sorted_sides(mesh, gone);
  const std::vector<MeshCell> quads = quad_cells(mesh, group_by_edge(sides));
  std::size_t count = 0;
  for (std::size_t i = 1; i < quads.size(); ++i) {
    if (!quads[i].has_same_corners(quads[i - 1]) || quads[i].rising != quads[i - 1].rising)
      continue;
    const auto is_there = [&](Index t) { return gone[t] == 0; };
    const auto &kept = quads[i - 1].triangles, &other = quads[i].triangles;
    if (!std::all_of(kept.begin(), kept.end(), is_there) ||
        !std::all_of(other.begin(), other.end(), is_there)) {
      continue;
    }
    for (const Index t : other)
      gone[t] = 1;
    count += 2;
  }
  return count;
}

/// Whether triangles are there in both orientations: then edges of several triangles do not tell
/// what stands on a surface.
bool has_opposites(const TriMesh& mesh, const Marks& gone) {
  const std::vector<MeshCell> cells = triangle_cells(mesh, gone);
  return std::adjacent_find(cells.begin(), cells.end(), [](const MeshCell& a, const MeshCell& b) {
           return a.has_same_corners(b);
         }) != cells.end();
}

std::size_t mark_fins(const TriMesh& mesh, Marks& gone) {
  if (has_opposites(mesh, gone)) return 0;
  const std::vector<EdgeSide> sides = sorted_sides(mesh, gone);
  const std::vector<EdgeSides> edges = group_by_edge(sides);
  const Sheets sheets = find_sheets(mesh.triangles.size(), edges, 2);
  std::vector<double> areas = unit_areas(mesh);
  for (std::size_t t = 0; t < areas.size(); ++t) {
    if (gone[t] != 0) areas[t] = 0.0;
  }
  const std::vector<double> of_sheet = sums_over(sheets, areas);
  const double whole = std::accumulate(areas.begin(), areas.end(), 0.0);
  const auto is_small = [&](const EdgeSide& side) {
    return of_sheet[sheets.of_triangle[side.triangle]] < k_fin * whole;
  };
  Marks stands(sheets.count, 0), needed(sheets.count, 0);
  for (const EdgeSides& edge : edges) {
    if (edge.size() <= 2) continue;
    const bool is_whole_without =
        edge.size() - static_cast<std::size_t>(std::count_if(edge.begin, edge.end, is_small)) == 2;
    for (const EdgeSide* side = edge.begin; side < edge.end; ++side)
      (is_whole_without ? stands : needed)[sheets.of_triangle[side->triangle]] = 1;
  }
  std::size_t count = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Index sheet = sheets.of_triangle[t];
    if (gone[t] != 0 || stands[sheet] == 0 || needed[sheet] != 0) continue;
    if (!(of_sheet[sheet] < k_fin * whole)) continue;
    gone[t] = 1;
    ++count;
  }
  return count;
}

}  // namespace

CleanedMesh remove_redundant_triangles(const TriMesh& mesh) {
  require_entries(mesh);
  // A manifold has no other dirt than doubled sheets.
  if (!may_be_doubled(mesh) && Connectivity::build(mesh)) return {unchanged(mesh)};
  Marks gone(mesh.triangles.size(), 0);
  CleanedMesh result;
  result.collapsed = mark_collapsed(mesh, gone);
  result.repeated = mark_repeated(mesh, gone);
  result.repeated += mark_other_diagonals(mesh, gone);
  const DoubledSheets doubled = find_doubled_sheets(mesh, gone);
  for (const auto* triangles : {&doubled.backs, &doubled.repeated}) {
    for (const Index t : *triangles)
      gone[t] = 1;
  }
  result.backs = doubled.backs.size();
  result.repeated += doubled.repeated.size();
  result.fins = mark_fins(mesh, gone);
  std::vector<Index> removed;
  for (std::size_t t = 0; t < gone.size(); ++t) {
    if (gone[t] != 0) removed.push_back(static_cast<Index>(t));
  }
  static_cast<RepairedMesh&>(result) = without_triangles(mesh, removed);
  return result;
}

}  // namespace planish
