#include "panels/folded_seams.h"

#include <algorithm>
#include <utility>

#include "panels/cells/halved_product.h"
#include "panels/divided_piece.h"

namespace planish {

namespace {

constexpr double k_of_half = 2.0;  // areas of a half, of those of the whole

/// Of edges of the whole those of the half, by their numbers there; the plane is border there.
OpenEdges on_half(const PanelMesh& whole, const PanelMesh& half, const OpenEdges& edges) {
  OpenEdges found(half.edges().size(), 0);
  for (std::size_t e = 0; e < found.size(); ++e) {
    const auto& [v, w] = half.edges()[e].ends;
    if (!half.edges()[e].is_border()) found[e] = edges[find_edge(whole, v, w)];
  }
  return found;
}

/// Where open edges of the plane follow each other along loops of the border of the half.
std::vector<FoldRun> open_runs(const PanelMesh& whole, const PanelMesh& half,
                               const OpenEdges& open) {
  std::vector<FoldRun> runs;
  for (const std::vector<Index>& loop : half.patch().border_loops()) {
    const std::size_t n = loop.size();
    const auto is_open = [&](std::size_t k) {
      return open[find_edge(whole, loop[k % n], loop[(k + 1) % n])] != 0;
    };
    std::size_t start = 0;
    while (start < n && is_open(start))
      ++start;
    if (start == n) {
      runs.push_back({loop[0], loop[0]});
      continue;
    }
    for (std::size_t k = start; k < start + n; ++k) {
      if (!is_open(k)) continue;
      const Index from = loop[k % n];
      while (is_open(k + 1))
        ++k;
      runs.push_back({from, loop[(k + 1) % n]});
    }
  }
  return runs;
}

/// Sets the edges of the plane along a run.
void set_open(const PanelMesh& whole, const Patch& half, const FoldRun& run, OpenEdges& open) {
  for (const std::vector<Index>& loop : half.border_loops()) {
    const auto found = std::find(loop.begin(), loop.end(), run.from);
    if (found == loop.end()) continue;
    if (std::find(loop.begin(), loop.end(), run.to) == loop.end()) return;
    auto k = static_cast<std::size_t>(found - loop.begin());
    do {
      const Index next = loop[(k + 1) % loop.size()];
      const Index e = find_edge(whole, loop[k], next);
      if (!whole.edges()[e].is_border()) open[e] = 1;
      k = (k + 1) % loop.size();
    } while (loop[k] != run.to);
    return;
  }
}

bool is_across(const PanelMesh& mesh, const std::vector<Index>& piece) {
  return mesh.is_image(piece.back()) && !mesh.is_image(piece.front());
}

}  // namespace

FoldedSeams folded_seams(const SeamNet& net, const OpenEdges& open) {
  PanelMesh half{Patch(half_of(net.mesh.patch().mesh()))};
  OpenEdges seams = on_half(net.mesh, half, net.seams), open_there = on_half(net.mesh, half, open);
  std::vector<FoldRun> runs = open_runs(net.mesh, half, open);
  return {{{std::move(half), std::move(seams), {}}, std::move(open_there)}, std::move(runs)};
}

CarriedSeams unfolded_seams(const FoldedSeams& folded, const Plane& plane) {
  const PanelMesh& half = folded.half.net.mesh;
  PanelMesh whole(half.patch(), plane);
  OpenEdges seams(whole.edges().size(), 0), open(whole.edges().size(), 0);
  for (std::size_t e = 0; e < half.edges().size(); ++e) {
    const auto& [v, w] = half.edges()[e].ends;
    const Index first = find_edge(whole, v, w);
    if (whole.edges()[first].is_border()) continue;
    for (const Index f : {first, whole.image_of_edge(first)}) {
      seams[f] = half.edges()[e].is_border() ? 1 : folded.half.net.seams[e];
      open[f] = folded.half.open[e];
    }
  }
  for (const FoldRun& run : folded.open)
    set_open(whole, half.patch(), run, open);
  std::vector<SeamChain> chains = chains_of_half(whole, seams);
  return {{std::move(whole), std::move(seams), std::move(chains)}, std::move(open)};
}

CarriedSeams carried_mirrored_seams(const Patch& half, const SeamNet& net, const OpenEdges& open,
                                    double least_area, const SeamMoves& moves) {
  const FoldedSeams thinned = folded_seams(net, open);
  FoldedSeams folded{
      carried_seams(half, thinned.half.net, thinned.half.open, k_of_half * least_area, moves), {}};
  const std::vector<Vec3>& places = thinned.half.net.mesh.patch().positions();
  for (const FoldRun& run : thinned.open) {
    const FoldRun there{nearest_on_border(half, places[run.from]),
                        nearest_on_border(half, places[run.to])};
    if (run.from == run.to || there.from != there.to) folded.open.push_back(there);
  }
  return unfolded_seams(folded, net.mesh.plane());
}

CarriedSeams with_mirrored_pieces_divided(const SeamNet& net, const OpenEdges& open,
                                          std::span<const std::vector<Index>> pieces,
                                          double least_area, ThreadPool& pool) {
  OpenEdges opened = open;
  std::vector<std::vector<Index>> of_half;
  for (const std::vector<Index>& piece : pieces) {
    if (net.mesh.is_image(piece.front())) continue;
    if (!is_across(net.mesh, piece)) {
      of_half.push_back(piece);
      continue;
    }
    for (const Index t : piece) {
      for (std::size_t i = 0; i < 3; ++i) {
        const Index e = net.mesh.edge_of(t, i);
        if (net.mesh.image_of_edge(e) == e && !net.mesh.edges()[e].is_border()) opened[e] = 1;
      }
    }
  }
  FoldedSeams folded = folded_seams(net, opened);
  folded.half =
      with_pieces_divided(folded.half.net, folded.half.open, of_half, k_of_half * least_area, pool);
  return unfolded_seams(folded, net.mesh.plane());
}

}  // namespace planish
