#include "panels/seams/seam_chains.h"

#include <algorithm>
#include <map>
#include <utility>

#include <planish/mesh/imprint.h>

#include "panels/cells/merge_cells.h"

namespace planish {

namespace {

class ChainFinder {
 public:
  ChainFinder(const PanelMesh& mesh, const OpenEdges& seams)
      : mesh_(mesh), at_(mesh.patch().vertex_count()), left_(seams) {
    for (Index e = 0; e < seams.size(); ++e) {
      if (seams[e] == 0) continue;
      for (const Index v : mesh.edges()[e].ends)
        at_[v].push_back(e);
    }
  }

  std::vector<SeamChain> find() {
    std::vector<SeamChain> chains;
    for (const bool round : {false, true}) {
      for (Index v = 0; v < at_.size(); ++v) {
        if (!round && !ends_at(v)) continue;
        for (const Index e : at_[v]) {
          if (left_[e] != 0) chains.push_back(chain_from(v, e));
        }
      }
    }
    return chains;
  }

 private:
  bool ends_at(Index v) const { return at_[v].size() != 2 || mesh_.patch().is_border(v); }

  SeamChain chain_from(Index v, Index e) {
    SeamChain chain;
    chain.vertices.push_back(v);
    while (true) {
      left_[e] = 0;
      chain.edges.push_back(e);
      const auto& ends = mesh_.edges()[e].ends;
      v = ends[ends[0] == v ? 1 : 0];
      chain.vertices.push_back(v);
      if (ends_at(v)) return chain;
      e = at_[v][at_[v][0] == e ? 1 : 0];
      if (left_[e] == 0) return chain;
    }
  }

  const PanelMesh& mesh_;
  std::vector<std::vector<Index>> at_;
  OpenEdges left_;
};

/// The smallest cell below the least area, joined to a neighbour; false where there is none.
bool join_smallest(const PanelMesh& mesh, std::vector<Index>& cells, double least_area) {
  std::map<Index, double> areas;
  for (Index t = 0; t < cells.size(); ++t)
    areas[cells[t]] += mesh.area(t);
  const auto smallest = std::min_element(
      areas.begin(), areas.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  if (areas.size() < 2 || smallest->second >= least_area) return false;
  std::map<Index, double> shared;
  for (const PanelEdge& edge : mesh.edges()) {
    if (edge.is_border()) continue;
    const Index a = cells[edge.triangles[0]], b = cells[edge.triangles[1]];
    if ((a == smallest->first) != (b == smallest->first))
      shared[a == smallest->first ? b : a] += edge.length;
  }
  if (shared.empty()) return false;
  const auto longest =
      std::max_element(shared.begin(), shared.end(),
                       [](const auto& a, const auto& b) { return a.second < b.second; });
  std::replace(cells.begin(), cells.end(), Index{smallest->first}, Index{longest->first});
  return true;
}

}  // namespace

std::vector<SeamChain> seam_chains(const PanelMesh& mesh, const OpenEdges& seams) {
  return ChainFinder(mesh, seams).find();
}

std::vector<SeamChain> chains_of_half(const PanelMesh& mesh, const OpenEdges& seams) {
  std::vector<SeamChain> chains = seam_chains(mesh, seams);
  std::erase_if(chains, [&](const SeamChain& chain) {
    return mesh.is_image(mesh.edges()[chain.edges.front()].triangles[0]);
  });
  return chains;
}

std::vector<Index> parts_of(const PanelMesh& mesh, const OpenEdges& open) {
  std::vector<Index> parts(mesh.triangles().size());
  Index number = 0;
  for (const std::vector<Index>& part : open_parts(mesh, open)) {
    for (const Index t : part)
      parts[t] = number;
    ++number;
  }
  return parts;
}

std::vector<Index> with_small_cells_joined(const PanelMesh& mesh, std::vector<Index> cells,
                                           double least_area) {
  while (join_smallest(mesh, cells, least_area)) {
  }
  return cells;
}

Index find_edge(const PanelMesh& mesh, Index v, Index w) {
  const std::array<Index, 2> ends = {std::min(v, w), std::max(v, w)};
  const auto found =
      std::lower_bound(mesh.edges().begin(), mesh.edges().end(), ends,
                       [](const PanelEdge& edge, const auto& key) { return edge.ends < key; });
  if (found == mesh.edges().end() || found->ends != ends) return PanelEdge::none;
  return static_cast<Index>(found - mesh.edges().begin());
}

CellMesh imprinted_cells(const Patch& patch, std::span<const SurfaceLine> lines,
                         double least_area) {
  ImprintedMesh imprinted = imprint(patch, lines);
  PanelMesh mesh{Patch(std::move(imprinted.mesh))};
  OpenEdges open(mesh.edges().size(), 0);
  for (const std::vector<Index>& path : imprinted.paths) {
    for (std::size_t i = 1; i < path.size(); ++i) {
      const Index e = find_edge(mesh, path[i - 1], path[i]);
      if (e != PanelEdge::none && !mesh.edges()[e].is_border()) open[e] = 1;
    }
  }
  std::vector<Index> cells = with_small_cells_joined(mesh, parts_of(mesh, open), least_area);
  cells = parts_of(mesh, open_between(mesh, cells));
  return {std::move(mesh), std::move(cells)};
}

}  // namespace planish
