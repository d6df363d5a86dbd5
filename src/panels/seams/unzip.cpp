#include "panels/seams/unzip.h"

#include <algorithm>
#include <limits>
#include <map>
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

/// Edges that might be opened together at the end of a closed run.
struct Opening {
  std::pair<Index, int> place;  // the other end of the run; which way it goes
  std::vector<Index> edges;
};

std::vector<Opening> openings(const SeamState& state, const std::vector<SeamChain>& chains,
                              std::size_t piece, double step) {
  std::vector<Opening> found;
  for (std::vector<Index> run : closed_runs(state, chains, piece)) {
    for (int way = 0; way < 2; ++way) {
      if (begins_open(state, run))
        found.push_back({{run.back(), way}, first_of(state.mesh(), run, step)});
      std::reverse(run.begin(), run.end());
    }
  }
  return found;
}

/// Looks for the opening that takes most energy for its length. What one took at the step before
/// is nearly always more than what it takes now: those that took less then are not tried.
class BestOpening {
 public:
  struct Found {
    SeamRun run;
    std::vector<PanelPiece> pieces;  // none where nothing helps
  };

  Found find(const SeamState& state, const std::vector<SeamChain>& chains, std::size_t piece,
             double step) {
    const std::vector<Opening> all = openings(state, chains, piece, step);
    std::vector<std::pair<double, std::size_t>> order;  // less what it last took; which
    for (std::size_t i = 0; i < all.size(); ++i) {
      const auto last = last_.find(all[i].place);
      order.emplace_back(last == last_.end() ? -k_unknown : -last->second, i);
    }
    std::sort(order.begin(), order.end());
    Found best;
    double most = 0.0;
    for (const auto& [last, i] : order) {
      if (-last < most) break;
      SeamRun run = state.run_of(all[i].edges);
      std::vector<PanelPiece> pieces = state.opened_pieces(run);
      double less = state.pieces()[piece].energy;
      for (const PanelPiece& part : pieces)
        less -= part.energy;
      const double taken = less / length_of(state.mesh(), run.edges);
      last_[all[i].place] = taken;
      if (taken > most) most = taken, best = {std::move(run), std::move(pieces)};
    }
    return best;
  }

 private:
  static constexpr double k_unknown = std::numeric_limits<double>::infinity();
  std::map<std::pair<Index, int>, double> last_;  // energy for length, by place
};

}  // namespace

bool unzip(SeamState& state, const std::vector<SeamChain>& chains, std::size_t piece, double limit,
           double step) {
  BestOpening openings;
  std::vector<std::size_t> over = {piece};
  while (!over.empty()) {
    const std::size_t p = over.back();
    if (state.pieces()[p].strain() <= limit) {
      over.pop_back();
      continue;
    }
    BestOpening::Found best = openings.find(state, chains, p, step);
    if (best.pieces.empty()) return false;
    over.pop_back();
    for (std::size_t k = 0; k < best.pieces.size(); ++k) {
      const bool is_image = state.mesh().is_image(best.pieces[k].triangles.front());
      if (!is_image) over.push_back(state.pieces().size() + k);
    }
    state.open(best.run, std::move(best.pieces));
  }
  return true;
}

}  // namespace planish
