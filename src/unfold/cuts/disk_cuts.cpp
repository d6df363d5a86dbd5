#include "unfold/cuts/disk_cuts.h"

#include <algorithm>

#include <planish/measure/flattenability.h>

#include "mesh/cut/inside_paths.h"

namespace planish {

std::vector<Index> cut_of_closed(const Patch& patch, std::span<const double> weights) {
  const std::vector<double> defects = angle_defects(patch);
  std::vector<double> around = defects;
  for (const Index v : patch.inner_vertices()) {
    for (const Index w : patch.ring(v))
      around[v] += defects[w];
  }
  const auto greatest = std::max_element(around.begin(), around.end());
  const auto from = static_cast<Index>(greatest - around.begin());
  InsidePaths inside(patch, weights);
  // A single edge would open nothing.
  const auto ring = patch.ring(from);
  const auto is_apart = [&](Index v) {
    return std::find(ring.begin(), ring.end(), v) == ring.end();
  };
  const double enough = 0.5 * *greatest;
  auto to = inside.farthest(from, [&](Index v) { return around[v] >= enough && is_apart(v); });
  if (!to) to = inside.farthest(from, [](Index) { return true; });
  auto path = inside.from(std::span(&from, 1), [&](Index v) { return v == *to; });
  // Of a tetrahedron, where all vertices are neighbours.
  if (path->size() == 2) path->push_back(ring[0] == *to ? ring[1] : ring[0]);
  return *path;
}

CutMesh cut_along(const Patch& patch, std::span<const std::vector<Index>> paths) {
  std::vector<CutPath> cuts;
  cuts.reserve(paths.size());
  for (const auto& path : paths)
    cuts.push_back({path});
  return cut_open(patch, cuts);
}

std::vector<Index> on_source(std::span<const Index> path, const CutMesh& cut) {
  std::vector<Index> vertices;
  vertices.reserve(path.size());
  for (const Index v : path)
    vertices.push_back(cut.source[v]);
  return vertices;
}

}  // namespace planish
