#include "panels/seams/unzip.h"

#include <algorithm>
#include <utility>

namespace planish {

namespace {

/// The first edges of a run, so long together.
std::vector<Index> first_of(const PanelMesh& mesh, const std::vector<Index>& run, double step) {
  std::vector<Index> edges;
  double length = 0.0;
  for (const Index e : run) {
    if (!edges.empty() && length + 0.5 * mesh.edges()[e].length > step) break;
    edges.push_back(e);
    length += mesh.edges()[e].length;
  }
  return edges;
}

/// The end of a run that only its first edge has.
bool begins_open(const SeamState& state, const std::vector<Index>& run) {
  const auto& ends = state.mesh().edges()[run.front()].ends;
  if (run.size() == 1) return state.is_open_at(ends[0]) || state.is_open_at(ends[1]);
  const auto& next = state.mesh().edges()[run[1]].ends;
  const bool second_is_shared = ends[1] == next[0] || ends[1] == next[1];
  return state.is_open_at(ends[second_is_shared ? 0 : 1]);
}

std::vector<std::vector<Index>> openings(const SeamState& state,
                                         const std::vector<SeamChain>& chains, std::size_t piece,
                                         double step) {
  std::vector<std::vector<Index>> found;
  for (std::vector<Index> run : closed_runs(state, chains, piece)) {
    for (int way = 0; way < 2; ++way) {
      if (begins_open(state, run)) found.push_back(first_of(state.mesh(), run, step));
      std::reverse(run.begin(), run.end());
    }
  }
  return found;
}

}  // namespace

bool unzip(SeamState& state, const std::vector<SeamChain>& chains, std::size_t piece, double limit,
           double step, ThreadPool& pool) {
  std::vector<std::size_t> over = {piece};
  while (!over.empty()) {
    const std::size_t p = over.back();
    if (state.pieces()[p].strain() <= limit) {
      over.pop_back();
      continue;
    }
    std::vector<SeamRun> ways;
    for (const std::vector<Index>& edges : openings(state, chains, p, step))
      ways.push_back(state.run_of(edges));
    std::vector<std::vector<PanelPiece>> pieces(ways.size());
    pool.for_ranges(ways.size(), 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        pieces[i] = state.opened_pieces(ways[i]);
    });
    std::size_t best = ways.size();
    double most = 0.0;
    for (std::size_t i = 0; i < ways.size(); ++i) {
      double less = state.pieces()[p].energy;
      for (const PanelPiece& part : pieces[i])
        less -= part.energy;
      const double length = length_of(state.mesh(), ways[i].edges);
      if (less / length > most) most = less / length, best = i;
    }
    if (best == ways.size()) return false;
    over.pop_back();
    for (std::size_t k = 0; k < pieces[best].size(); ++k) {
      const bool is_image = state.mesh().is_image(pieces[best][k].triangles.front());
      if (!is_image) over.push_back(state.pieces().size() + k);
    }
    state.open(ways[best], std::move(pieces[best]));
  }
  return true;
}

}  // namespace planish
