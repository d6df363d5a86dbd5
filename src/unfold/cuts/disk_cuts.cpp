#include "unfold/cuts/disk_cuts.h"

#include <algorithm>
#include <string>

#include <planish/measure/flattenability.h>
#include <planish/mesh/inspect.h>
#include <planish/unfold/suggest_cuts.h>

#include "mesh/cut/inside_paths.h"
#include "unfold/cuts/handle_cuts.h"

namespace planish {

namespace {

std::vector<Index> cut_of_closed(const Patch& patch) {
  const std::vector<double> defects = angle_defects(patch);
  std::vector<double> around = defects;
  for (const Index v : patch.inner_vertices()) {
    for (const Index w : patch.ring(v))
      around[v] += defects[w];
  }
  const auto greatest = std::max_element(around.begin(), around.end());
  const auto from = static_cast<Index>(greatest - around.begin());
  InsidePaths inside(patch);
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

std::vector<Index> cut_between_borders(const Patch& patch) {
  const auto& loops = patch.border_loops();
  std::vector<unsigned char> on_other(patch.vertex_count(), 0);
  for (std::size_t k = 1; k < loops.size(); ++k) {
    for (const Index v : loops[k])
      on_other[v] = 1;
  }
  InsidePaths inside(patch);
  auto path = inside.from(loops.front(), [&](Index v) { return on_other[v] != 0; });
  if (!path) require(patch.inspection(), Purpose::unfold);
  return *path;
}

std::size_t handles_of(const Patch& patch) {
  return patch.inspection().topology.genus;
}

}  // namespace

std::vector<std::vector<Index>> cut_graph(const Patch& patch) {
  const Topology& topology = patch.inspection().topology;
  if (topology.components != 1) {
    throw Error(ErrorCode::several_components,
                "the mesh has " + std::to_string(topology.components) + " separate parts");
  }
  std::vector<std::vector<Index>> paths;
  if (patch.border_loops().empty()) {
    if (handles_of(patch) > 0) return handle_cuts(patch);
    paths.push_back(cut_of_closed(patch));
    return paths;
  }
  while (paths.size() + 1 < patch.border_loops().size()) {
    const CutMesh cut = cut_along(patch, paths);
    paths.push_back(on_source(cut_between_borders(Patch(cut.mesh)), cut));
  }
  if (handles_of(patch) > 0) {
    const CutMesh cut = cut_along(patch, paths);
    for (const std::vector<Index>& path : handle_cuts(Patch(cut.mesh)))
      paths.push_back(on_source(path, cut));
  }
  return paths;
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
