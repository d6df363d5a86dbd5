#include "panels/carried_seams.h"

#include <utility>

#include <planish/mesh/carry.h>
#include <planish/mesh/imprint.h>

#include "panels/cells/merge_cells.h"

namespace planish {

namespace {

constexpr double k_most_move = 0.5;  // mean edges of the thinned product
constexpr int k_straightenings = 40;

/// A line of less length near a drawn one, its ends held: each point goes towards the line between
/// those before and after it, to the share of the way that it is at.
DrawnLine straightened(DrawnLine line, double most_move) {
  const std::vector<Vec3> drawn = line.points;
  for (int round = 0; round < k_straightenings; ++round) {
    for (std::size_t i = 1; i + 1 < drawn.size(); ++i) {
      const Vec3 before = line.points[i - 1], after = line.points[i + 1];
      const double to_before = norm(line.points[i] - before);
      const double way = to_before + norm(after - line.points[i]);
      if (!(way > 0.0)) continue;
      const Vec3 away = before + (to_before / way) * (after - before) - drawn[i];
      const double far = norm(away);
      line.points[i] = drawn[i] + (far > most_move ? most_move / far : 1.0) * away;
    }
  }
  return line;
}

/// A part of a chain that is open all along, or closed.
struct Run {
  DrawnLine line;
  bool is_open = false;
};

std::vector<Run> runs_of(const SeamNet& net, const SeamChain& chain, const OpenEdges& open) {
  DrawnLine line;
  for (const Index v : chain.vertices)
    line.points.push_back(net.mesh.patch().positions()[v]);
  line = straightened(std::move(line), k_most_move * net.mesh.mean_edge() / net.mesh.scale());
  std::vector<Run> runs;
  for (std::size_t i = 0; i < chain.edges.size(); ++i) {
    const bool is_open = open[chain.edges[i]] != 0;
    if (runs.empty() || runs.back().is_open != is_open)
      runs.push_back({{{line.points[i]}, {}}, is_open});
    runs.back().line.points.push_back(line.points[i + 1]);
  }
  return runs;
}

void set_edges(const PanelMesh& mesh, const std::vector<Index>& path, OpenEdges& edges) {
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Index e = find_edge(mesh, path[i - 1], path[i]);
    if (e != PanelEdge::none && !mesh.edges()[e].is_border()) edges[e] = 1;
  }
}

}  // namespace

CarriedSeams imprinted_seams(const Patch& patch, std::span<const SurfaceLine> lines,
                             std::span<const unsigned char> is_open, double least_area) {
  ImprintedMesh imprinted = imprint(patch, lines);
  PanelMesh mesh{Patch(std::move(imprinted.mesh))};
  OpenEdges seams(mesh.edges().size(), 0), open(mesh.edges().size(), 0);
  for (std::size_t l = 0; l < lines.size(); ++l) {
    set_edges(mesh, imprinted.paths[l], seams);
    if (is_open[l] != 0) set_edges(mesh, imprinted.paths[l], open);
  }
  const std::vector<Index> parts = parts_of(mesh, open);
  const std::vector<Index> joined = with_small_cells_joined(mesh, parts, least_area);
  for (Index e = 0; e < open.size(); ++e) {
    const auto& sides = mesh.edges()[e].triangles;
    if (open[e] != 0 && parts[sides[0]] != parts[sides[1]] && joined[sides[0]] == joined[sides[1]])
      open[e] = 0;
  }
  std::vector<SeamChain> chains = seam_chains(mesh, seams);
  return {{std::move(mesh), std::move(seams), std::move(chains)}, std::move(open)};
}

CarriedSeams carried_seams(const Patch& product, const SeamNet& net, const OpenEdges& open,
                           double least_area) {
  std::vector<SurfaceLine> lines;
  std::vector<unsigned char> is_open;
  for (const SeamChain& chain : net.chains) {
    for (const Run& run : runs_of(net, chain, open)) {
      for (SurfaceLine& line : trace_lines(product, {{run.line}, {}}).lines) {
        lines.push_back(std::move(line));
        is_open.push_back(run.is_open ? 1 : 0);
      }
    }
  }
  return imprinted_seams(product, lines, is_open, least_area);
}

}  // namespace planish
