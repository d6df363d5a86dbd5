#include "panels/seams/zip.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace planish {

namespace {

constexpr double k_never = std::numeric_limits<double>::infinity();
// An action that would add so much of what it last did and break the limit is not tried.
constexpr double k_as_before = 0.85;
constexpr double k_least_piece = 0.01;  // of the area
constexpr double k_unfit = 1e-3;        // of the ratio of an action that joins an unfit piece

/// Whether a piece is to be joined to another one while that has some strain to spare.
bool is_unfit(const PanelPiece& piece, double limit) {
  return piece.strain() > limit || piece.area < k_least_piece;
}

}  // namespace

std::vector<Index> Zip::edges_of(const Action& action) const {
  const std::vector<Index>& edges = chains_[action.chain].edges;
  return {edges.begin() + static_cast<std::ptrdiff_t>(action.first),
          edges.begin() + static_cast<std::ptrdiff_t>(action.last)};
}

void Zip::add_actions_of(const SeamState& state, std::size_t chain, std::size_t first,
                         std::size_t last, double step, std::vector<Action>& found) const {
  const auto& all = state.mesh().edges();
  const std::vector<Index>& edges = chains_[chain].edges;
  double length = 0.0;
  for (std::size_t i = first; i < last; ++i)
    length += all[edges[i]].length;
  if (length <= 1.5 * step || last - first == 1) {
    found.push_back({chain, first, last, 3});
    return;
  }
  // The first place at which so much of the run is behind.
  const auto place_at = [&](double behind) {
    double sum = 0.0;
    std::size_t i = first;
    while (i < last && sum + 0.5 * all[edges[i]].length < behind)
      sum += all[edges[i++]].length;
    return i;
  };
  const std::size_t front = std::max(place_at(step), first + 1);
  const std::size_t back = std::min(place_at(length - step), last - 1);
  found.push_back({chain, first, front, 0});
  found.push_back({chain, back, last, 1});
  const auto& sides = all[edges[first]].triangles;
  if (state.piece_of(sides[0]) == state.piece_of(sides[1])) return;
  const std::size_t begin = place_at(0.5 * (length - step)), end = place_at(0.5 * (length + step));
  if (begin > first && end < last && begin < end) found.push_back({chain, begin, end, 2});
  // In steps it would leave tips on the way.
  const bool is_on_plane =
      state.mesh().is_mirrored() && state.mesh().image_of_edge(edges[first]) == edges[first];
  if (prices_.tip > 0.0 || is_on_plane) found.push_back({chain, first, last, 3});
}

std::vector<Zip::Action> Zip::actions(const SeamState& state, const OpenEdges& held,
                                      double step) const {
  std::vector<Action> found;
  for (std::size_t c = 0; c < chains_.size(); ++c) {
    const std::vector<Index>& edges = chains_[c].edges;
    const auto may_close = [&](std::size_t i) {
      return state.open()[edges[i]] != 0 && held[edges[i]] == 0;
    };
    for (std::size_t first = 0; first < edges.size();) {
      std::size_t last = first;
      while (last < edges.size() && may_close(last))
        ++last;
      if (last > first) add_actions_of(state, c, first, last, step, found);
      first = last + 1;
    }
  }
  return found;
}

Zip::Key Zip::key_of(const SeamState& state, const Action& action) const {
  const Index edge = chains_[action.chain].edges[action.first];
  const auto& sides = state.mesh().edges()[edge].triangles;
  const auto [low, high] = std::minmax({state.piece_of(sides[0]), state.piece_of(sides[1])});
  return {action.chain, action.first, action.last, low, high};
}

Zip::Outcome Zip::try_out(const SeamState& state, const Action& action) const {
  Outcome outcome{{}, k_never, k_never};
  const SeamRun run = state.run_of(edges_of(action));
  double before = 0.0, area = 0.0;
  std::size_t loops = 1;  // less one where two pieces meet
  for (const Index p : run.pieces) {
    before += state.pieces()[p].energy;
    area += state.pieces()[p].area;
    loops += state.pieces()[p].cut_loops;
  }
  loops -= std::min(loops, run.pieces.size());
  const double most = limit_ * limit_ * area;
  const double gain = length_of(state.mesh(), run.edges) +
                      prices_.piece * static_cast<double>(run.pieces.size() - 1) -
                      prices_.tip * state.more_tips(run.edges);
  if (before > most || gain <= 0.0) return outcome;
  // No piece becomes a ring around another; holes of the mesh may stay.
  outcome.piece = state.closed_piece(run, std::max<std::size_t>(loops, 1));
  outcome.more = std::max(outcome.piece.energy - before, 0.0);
  if (outcome.piece.energy > most) return outcome;
  outcome.ratio = outcome.more / gain * (favour_.empty() ? 1.0 : favour_[action.chain]);
  if (joins_unfit(state, action)) outcome.ratio *= k_unfit;
  return outcome;
}

bool Zip::joins_unfit(const SeamState& state, const Action& action) const {
  const auto& sides = state.mesh().edges()[chains_[action.chain].edges[action.first]].triangles;
  const Index p = state.piece_of(sides[0]), q = state.piece_of(sides[1]);
  return p != q && (is_unfit(state.pieces()[p], limit_) || is_unfit(state.pieces()[q], limit_));
}

bool Zip::is_hopeless(const SeamState& state, const Action& action, double step) const {
  const auto last = last_more_.find({step, action.chain, action.way});
  if (action.way == 3 || last == last_more_.end()) return false;
  const Index edge = chains_[action.chain].edges[action.first];
  const auto& sides = state.mesh().edges()[edge].triangles;
  const Index p = state.piece_of(sides[0]), q = state.piece_of(sides[1]);
  if (p != q) return false;
  const PanelPiece& piece = state.pieces()[p];
  return piece.energy + k_as_before * last->second > limit_ * limit_ * piece.area;
}

std::optional<std::size_t> Zip::best_of(const SeamState& state, const std::vector<Action>& all,
                                        double step) {
  std::vector<std::pair<double, std::size_t>> order;  // the last ratio; the action
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto last = last_ratio_.find({step, all[i].chain, all[i].way});
    const bool is_first = last == last_ratio_.end() || joins_unfit(state, all[i]);
    order.emplace_back(is_first ? 0.0 : last->second, i);
  }
  std::sort(order.begin(), order.end());
  double best_ratio = k_never;
  std::optional<std::size_t> best;
  for (const auto& [last, i] : order) {
    if (last > best_ratio) break;
    const Key key = key_of(state, all[i]);
    if (!known_.contains(key)) {
      known_[key] =
          is_hopeless(state, all[i], step) ? Outcome{{}, k_never, k_never} : try_out(state, all[i]);
    }
    const auto& [piece, ratio, more] = known_.at(key);
    const Place place{step, all[i].chain, all[i].way};
    last_ratio_[place] = ratio;
    if (more < k_never) last_more_[place] = more;
    if (ratio < best_ratio) best_ratio = ratio, best = i;
  }
  return best;
}

bool Zip::close_best(SeamState& state, const OpenEdges& held, double step) {
  const std::vector<Action> all = actions(state, held, step);
  std::optional<std::size_t> best;
  SeamRun run;
  while (true) {
    best = best_of(state, all, step);
    if (!best) return false;
    run = state.run_of(edges_of(all[*best]));
    if (run.pieces.size() == 1 || !may_join_ || may_join_(state, run)) break;
    known_.at(key_of(state, all[*best])).ratio = k_never;
  }
  PanelPiece piece = std::move(known_.at(key_of(state, all[*best])).piece);
  std::erase_if(known_, [&](const auto& entry) {
    const auto is_gone = [&](Index p) {
      return std::find(run.pieces.begin(), run.pieces.end(), p) != run.pieces.end();
    };
    return is_gone(std::get<3>(entry.first)) || is_gone(std::get<4>(entry.first));
  });
  state.close(run, std::move(piece));
  return true;
}

void Zip::run(SeamState& state, const OpenEdges& held) {
  for (const double step : {0.15, 0.05, state.mesh().mean_edge()}) {
    known_.clear();
    while (close_best(state, held, step)) {
    }
  }
}

}  // namespace planish
