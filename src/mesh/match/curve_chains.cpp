#include "mesh/match/curve_chains.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

namespace planish {

namespace {

using Place = std::array<double, 2>;

constexpr double k_next = 1.0 + 1e-9;    // no vertex of either border lies between
constexpr double k_back = 1.0;           // edges that a place may lie behind the one before it
constexpr double k_jag = 6.0;            // mean edges of the border with the shorter ones
constexpr double k_jag_vertices = 13.0;  // of each border

/// Places on two loops, of which the second one runs along the first or against it.
class LoopPair {
 public:
  LoopPair(const BorderLines& borders, const BoundaryCorrespondence& any)
      : borders_(borders),
        numbers_(any.loops),
        loops_{borders.loops()[any.loops[0]], borders.loops()[any.loops[1]]},
        reversed_(any.reversed) {}

  std::vector<CurveChain> chains(std::vector<Place> places) const {
    std::sort(places.begin(), places.end(), [&](const Place& a, const Place& b) {
      return std::pair(a[0], sign() * a[1]) < std::pair(b[0], sign() * b[1]);
    });
    std::vector<CurveChain> chains = without_jags(swept(places));
    return numbers_[0] == numbers_[1] ? without_swapped(std::move(chains)) : chains;
  }

 private:
  double sign() const { return reversed_ ? -1.0 : 1.0; }
  double count(std::size_t side) const { return static_cast<double>(loops_[side].count); }

  /// How far the loops go on from one place to the other, the second one by its shorter way.
  Place step(const Place& from, const Place& to) const {
    return {to[0] - from[0], sign() * (reached(from, to)[1] - from[1])};
  }

  /// Past the tip of a dart its two sides would change their parts.
  bool is_past_tip(const Place& from, const Place& to) const {
    if (numbers_[0] != numbers_[1]) return false;
    const auto apart = [&](const Place& place) {
      const double n = count(0), d = place[1] - place[0];
      return d - n * std::floor(d / n);
    };
    return std::abs(apart(to) - apart(from)) > 0.5 * count(0);
  }

  /// The place as it is reached from another one.
  Place reached(const Place& from, const Place& to) const {
    const double n = count(1);
    return {to[0], to[1] - n * std::round((to[1] - from[1]) / n)};
  }

  CurveChain chain_of(const Place& place) const { return {numbers_, reversed_, false, {place}}; }

  std::vector<CurveChain> swept(const std::vector<Place>& places) const {
    std::vector<CurveChain> done, open;
    for (const Place& place : places) {
      const auto first_ended = std::stable_partition(
          open.begin(), open.end(),
          [&](const CurveChain& chain) { return place[0] - chain.at.back()[0] <= k_next; });
      std::move(first_ended, open.end(), std::back_inserter(done));
      open.erase(first_ended, open.end());
      if (CurveChain* chain = nearest_end(open, place))
        go_on(*chain, place);
      else
        open.push_back(chain_of(place));
    }
    std::move(open.begin(), open.end(), std::back_inserter(done));
    std::sort(done.begin(), done.end(),
              [](const CurveChain& a, const CurveChain& b) { return a.at.front() < b.at.front(); });
    return done;
  }

  /// The chain that the place goes on with.
  CurveChain* nearest_end(std::vector<CurveChain>& open, const Place& place) const {
    CurveChain* nearest = nullptr;
    double least = 0.0;
    for (CurveChain& chain : open) {
      const Place on = step(chain.at.back(), place);
      if (on[1] < -k_back || on[1] > k_next || is_past_tip(chain.at.back(), place)) continue;
      const double far = on[0] + std::abs(on[1]);
      if (nearest != nullptr && far >= least) continue;
      nearest = &chain;
      least = far;
    }
    return nearest;
  }

  /// Places behind the end belong to the chain and add nothing.
  void go_on(CurveChain& chain, const Place& place) const {
    const Place on = step(chain.at.back(), place);
    if (on[1] < 0.0 || (on[0] == 0.0 && on[1] == 0.0)) return;
    chain.at.push_back(reached(chain.at.back(), place));
  }

  /// The way that both loops have from a chain's end to another's begin, if that goes on with it.
  std::optional<double> gap(const CurveChain& from, const CurveChain& to) const {
    Place begin = to.at.front();
    const Place& end = from.at.back();
    const bool is_itself = &from == &to;
    while (begin[0] < end[0] || (is_itself && begin[0] == end[0]))
      begin[0] += count(0);
    const Place on = step(end, begin);
    const bool is_far = on[0] > k_jag_vertices || on[1] > k_jag_vertices || on[1] < -k_back;
    if (is_far || is_past_tip(end, begin)) return std::nullopt;
    const Place there = reached(end, begin);
    double most = 0.0;
    for (std::size_t side = 0; side < 2; ++side) {
      const BorderLoop& loop = loops_[side];
      most = std::max(
          most, std::abs(borders_.way_to(loop, there[side]) - borders_.way_to(loop, end[side])));
    }
    if (on[0] <= k_next && on[1] <= k_next) return most;
    const double longest = k_jag * std::min(loops_[0].mean_edge(), loops_[1].mean_edge());
    const double both = from.length(borders_, 0) + (is_itself ? 0.0 : to.length(borders_, 0));
    return most <= longest && 2.0 * most <= both ? std::optional(most) : std::nullopt;
  }

  struct Link {
    double length, gap;  // of the shorter chain; between the two
    std::size_t from, to;
  };

  /// What may go on with each chain, long ones first.
  std::vector<Link> links(const std::vector<CurveChain>& chains) const {
    std::vector<Link> links;
    for (std::size_t c = 0; c < chains.size(); ++c) {
      for (const double turn : {0.0, count(0)}) {
        const double end = chains[c].at.back()[0] - turn;
        auto to = std::lower_bound(
            chains.begin(), chains.end(), end,
            [](const CurveChain& chain, double place) { return chain.at.front()[0] < place; });
        for (; to != chains.end() && to->at.front()[0] <= end + k_jag_vertices; ++to) {
          const auto way = gap(chains[c], *to);
          if (!way) continue;
          const double length = std::min(chains[c].length(borders_, 0), to->length(borders_, 0));
          links.push_back({length, *way, c, static_cast<std::size_t>(to - chains.begin())});
        }
      }
    }
    std::sort(links.begin(), links.end(), [](const Link& a, const Link& b) {
      return std::tie(b.length, a.gap, a.from, a.to) < std::tie(a.length, b.gap, b.from, b.to);
    });
    return links;
  }

  std::vector<CurveChain> without_jags(const std::vector<CurveChain>& chains) const {
    const std::size_t none = chains.size();
    std::vector<std::size_t> next(chains.size(), none), previous(chains.size(), none);
    for (const Link& link : links(chains)) {
      if (next[link.from] != none || previous[link.to] != none) continue;
      next[link.from] = link.to;
      previous[link.to] = link.from;
    }
    std::vector<CurveChain> joined;
    std::vector<bool> is_done(chains.size(), false);
    const auto join_from = [&](std::size_t first) {
      CurveChain& chain = joined.emplace_back(chains[first]);
      is_done[first] = true;
      std::size_t c = first;
      for (; next[c] != none && !is_done[next[c]]; is_done[c] = true)
        append(chain, chains[c = next[c]]);
      if (next[c] == first) close(chain);
    };
    for (std::size_t c = 0; c < chains.size(); ++c)
      if (previous[c] == none) join_from(c);
    for (std::size_t c = 0; c < chains.size(); ++c)
      if (!is_done[c]) join_from(c);
    return joined;
  }

  void append(CurveChain& chain, const CurveChain& more) const {
    for (Place place : more.at) {
      while (place[0] < chain.at.front()[0])
        place[0] += count(0);
      const Place on = step(chain.at.back(), place);
      if (on[0] < 0.0 || on[1] < 0.0 || (on[0] == 0.0 && on[1] == 0.0)) continue;
      chain.at.push_back(reached(chain.at.back(), place));
    }
  }

  /// Both loops are gone round once, or else it stays open.
  void close(CurveChain& chain) const {
    const Place first = chain.at.front();
    const Place on = step(chain.at.back(), first);
    const Place end = {first[0] + count(0), chain.at.back()[1] + sign() * on[1]};
    if (std::abs(std::abs(end[1] - first[1]) - count(1)) > 0.5) return;
    while (chain.at.size() > 1 &&
           (chain.at.back()[0] >= end[0] || sign() * (end[1] - chain.at.back()[1]) <= 0.0)) {
      chain.at.pop_back();
    }
    chain.at.push_back({end[0], first[1] + sign() * count(1)});
    chain.closed = true;
  }

  /// Places of one loop stand in both orders, so a chain does too.
  std::vector<CurveChain> without_swapped(std::vector<CurveChain> chains) const {
    constexpr double parts = 1024.0;  // of an edge: turns round the loop leave rounding behind
    const auto on_loop = [&](double place) {
      const double n = count(0);
      return std::llround(parts * (place - n * std::floor(place / n)));
    };
    std::set<std::pair<long long, long long>> swapped;
    std::vector<CurveChain> kept;
    for (CurveChain& chain : chains) {
      const bool is_known = std::any_of(chain.at.begin(), chain.at.end(), [&](const Place& place) {
        return swapped.count({on_loop(place[0]), on_loop(place[1])}) > 0;
      });
      if (is_known) continue;
      for (const Place& place : chain.at)
        swapped.insert({on_loop(place[1]), on_loop(place[0])});
      kept.push_back(std::move(chain));
    }
    return kept;
  }

  const BorderLines& borders_;
  std::array<std::size_t, 2> numbers_;
  std::array<BorderLoop, 2> loops_;
  bool reversed_;
};

}  // namespace

double CurveChain::length(const BorderLines& borders, std::size_t side) const {
  const BorderLoop& loop = borders.loops()[loops[side]];
  return std::abs(borders.way_to(loop, at.back()[side]) - borders.way_to(loop, at.front()[side]));
}

std::vector<CurveChain> find_curve_chains(const BorderLines& borders,
                                          std::vector<BoundaryCorrespondence> places) {
  const auto pair_of = [](const BoundaryCorrespondence& place) {
    return std::pair(place.loops, place.reversed);
  };
  std::stable_sort(places.begin(), places.end(),
                   [&](const auto& a, const auto& b) { return pair_of(a) < pair_of(b); });
  std::vector<CurveChain> all;
  for (std::size_t k = 0; k < places.size();) {
    const BoundaryCorrespondence& first = places[k];
    std::vector<Place> of_pair;
    for (; k < places.size() && pair_of(places[k]) == pair_of(first); ++k)
      of_pair.push_back(places[k].at);
    std::vector<CurveChain> chains = LoopPair(borders, first).chains(std::move(of_pair));
    std::move(chains.begin(), chains.end(), std::back_inserter(all));
  }
  return all;
}

}  // namespace planish
