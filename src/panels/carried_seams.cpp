#include "panels/carried_seams.h"

#include <limits>
#include <utility>

#include <planish/mesh/carry.h>
#include <planish/mesh/imprint.h>

#include "mesh/disjoint_sets.h"
#include "panels/cells/merge_cells.h"
#include "panels/seam_tracer.h"

namespace planish {

namespace {

constexpr int k_straightenings = 60;

/// Makes a line shorter near where it is, its ends held: each vertex goes towards the line between
/// those before and after it, to the share of the way that it is at.
/// @param places of all vertices
/// @param origin where they were
/// @param held by vertex: those that stay
void straighten(const std::vector<Index>& line, std::span<const Vec3> origin,
                std::span<const unsigned char> held, double most_move, std::vector<Vec3>& places) {
  for (int round = 0; round < k_straightenings; ++round) {
    for (std::size_t i = 1; i + 1 < line.size(); ++i) {
      if (held[line[i]] != 0) continue;
      const Vec3 before = places[line[i - 1]], after = places[line[i + 1]], start = origin[line[i]];
      const double to_before = norm(places[line[i]] - before);
      const double way = to_before + norm(after - places[line[i]]);
      if (!(way > 0.0)) continue;
      const Vec3 away = before + (to_before / way) * (after - before) - start;
      const double far = norm(away);
      places[line[i]] = start + (far > most_move ? most_move / far : 1.0) * away;
    }
  }
}

/// A stretch of a chain, of edges on creases or of others.
struct Stretch {
  DrawnLine line;
  bool is_crease = false;
};

/// A chain of edges that are open, or of closed ones.
struct Run {
  std::vector<Stretch> stretches;  // one after the other
  bool is_open = false;
};

/// Puts ends of lines that are on the border of the thinned product onto that of the product.
void lead_to_border(const Patch& product, const SeamChain& chain, const Patch& thinned, Run& run) {
  const auto lead = [&](Index v, Vec3& end) {
    if (thinned.is_border(v)) end = product.positions()[nearest_on_border(product, end)];
  };
  lead(chain.vertices.front(), run.stretches.front().line.points.front());
  lead(chain.vertices.back(), run.stretches.back().line.points.back());
}

Run run_of(const SeamNet& net, const SeamChain& chain, std::span<const Vec3> places, bool is_open) {
  Run run{{}, is_open};
  for (std::size_t k = 0; k < chain.edges.size(); ++k) {
    const bool is_on_crease = is_crease(net.mesh, net.mesh.edges()[chain.edges[k]]);
    if (run.stretches.empty() || run.stretches.back().is_crease != is_on_crease)
      run.stretches.push_back({{{places[chain.vertices[k]]}, {}}, is_on_crease});
    run.stretches.back().line.points.push_back(places[chain.vertices[k + 1]]);
  }
  return run;
}

/// Open ones go on where closed ones end.
std::vector<Run> straight_runs(const Patch& product, const SeamNet& net, const OpenEdges& open,
                               double most_move) {
  const OpenEdges closed = net.closed(open);
  const std::vector<Vec3>& origin = net.mesh.patch().positions();
  const double farthest = most_move * net.mesh.mean_edge() / net.mesh.scale();
  std::vector<Vec3> places = origin;
  std::vector<unsigned char> held(places.size(), 0);
  for (std::size_t e = 0; e < open.size(); ++e) {
    if (net.seams[e] == 0 || !is_crease(net.mesh, net.mesh.edges()[e])) continue;
    for (const Index v : net.mesh.edges()[e].ends)
      held[v] = 1;
  }
  std::vector<Run> runs;
  for (const bool is_open : {true, false}) {
    for (const SeamChain& chain : seam_chains(net.mesh, is_open ? open : closed)) {
      straighten(chain.vertices, origin, held, farthest, places);
      runs.push_back(run_of(net, chain, places, is_open));
      lead_to_border(product, chain, net.mesh.patch(), runs.back());
    }
    // Closed lines leave open ones where they are.
    for (std::size_t e = 0; e < open.size(); ++e) {
      for (const Index v : net.mesh.edges()[e].ends)
        held[v] = static_cast<unsigned char>(held[v] | open[e]);
    }
  }
  return runs;
}

void set_edges(const PanelMesh& mesh, const std::vector<Index>& path, OpenEdges& edges) {
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Index e = find_edge(mesh, path[i - 1], path[i]);
    if (e != PanelEdge::none && !mesh.edges()[e].is_border()) edges[e] = 1;
  }
}

/// Closes slits that meet neither the border nor the outline of their piece: they would open holes.
void close_islands(const PanelMesh& mesh, OpenEdges& open) {
  DisjointSets<Index> sets(mesh.patch().vertex_count());  // joined by open edges and the border
  for (Index e = 0; e < open.size(); ++e) {
    if (open[e] != 0 || mesh.edges()[e].is_border())
      sets.join(mesh.edges()[e].ends[0], mesh.edges()[e].ends[1]);
  }
  const std::vector<Index> parts = parts_of(mesh, open);
  // What bounds each part: one of the sets, or more.
  constexpr Index k_several = PanelEdge::none - 1;
  std::vector<Index> bound(mesh.triangles().size(), PanelEdge::none);
  std::vector<unsigned char> is_outline(mesh.patch().vertex_count(), 0);  // by set
  for (Index e = 0; e < open.size(); ++e) {
    const PanelEdge& edge = mesh.edges()[e];
    if (open[e] == 0 && !edge.is_border()) continue;
    const Index set = sets.first_of(edge.ends[0]);
    if (edge.is_border() || parts[edge.triangles[0]] != parts[edge.triangles[1]])
      is_outline[set] = 1;
    for (const Index t : edge.triangles) {
      if (t == PanelEdge::none) continue;
      Index& of_part = bound[parts[t]];
      of_part = of_part == PanelEdge::none || of_part == set ? set : k_several;
    }
  }
  for (Index e = 0; e < open.size(); ++e) {
    if (open[e] == 0 || is_outline[sets.first_of(mesh.edges()[e].ends[0])] != 0) continue;
    if (bound[parts[mesh.edges()[e].triangles[0]]] == k_several) open[e] = 0;
  }
}

}  // namespace

Index nearest_on_border(const Patch& patch, Vec3 place) {
  Index nearest = 0;
  double least = std::numeric_limits<double>::infinity();
  for (const std::vector<Index>& loop : patch.border_loops()) {
    for (const Index v : loop) {
      const double distance = norm(patch.positions()[v] - place);
      if (distance < least) least = distance, nearest = v;
    }
  }
  return nearest;
}

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
  close_islands(mesh, open);
  std::vector<SeamChain> chains = seam_chains(mesh, seams);
  return {{std::move(mesh), std::move(seams), std::move(chains)}, std::move(open)};
}

CarriedSeams carried_seams(const Patch& product, const SeamNet& net, const OpenEdges& open,
                           double least_area, const SeamMoves& moves) {
  const std::vector<Run> runs = straight_runs(product, net, open, moves.straightened);
  std::vector<DrawnLine> drawn;
  for (const Run& run : runs) {
    for (const Stretch& stretch : run.stretches)
      drawn.push_back(stretch.line);
  }
  const SeamTracer tracer(product);
  const std::vector<SurfaceLine> traced = tracer.traced(drawn);
  std::vector<SurfaceLine> lines;
  std::vector<unsigned char> is_open;
  std::size_t k = 0;
  for (const Run& run : runs) {
    std::vector<SurfaceLine> parts;
    for (const Stretch& stretch : run.stretches) {
      const SurfaceLine& line = traced[k++];
      if (line.size() < 2) continue;
      parts.push_back(stretch.is_crease ? line : tracer.fair(line, moves.tight, moves.rounds));
    }
    if (parts.empty()) continue;
    lines.push_back(tracer.joined(parts));
    is_open.push_back(run.is_open ? 1 : 0);
  }
  return imprinted_seams(product, lines, is_open, least_area);
}

}  // namespace planish
