#include "evolve/state/vertex_coloring.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <unordered_map>
#include <utility>

namespace planish {

namespace {

/// Above this valence the colours around a vertex are kept in a set of their own: looking through
/// its ring again for each of its neighbours would take quadratic time.
constexpr std::size_t k_hub_valence = 64;

/// Colours that are in use somewhere, counted from 0.
class UsedColors {
 public:
  bool uses(Index color) const { return color < used_.size() && used_[color] != 0; }
  void use(Index color) {
    if (color >= used_.size()) used_.resize(std::max<std::size_t>(color + 1, 2 * used_.size()), 0);
    used_[color] = 1;
    while (uses(first_free_))
      ++first_free_;
  }
  /// All colours below are in use.
  Index first_free() const { return first_free_; }

 private:
  std::vector<unsigned char> used_;
  Index first_free_ = 0;
};

/// Colours of which a vertex may not get any, for one vertex after another.
class Palette {
 public:
  void forbid(Index color, Index v) {
    if (color >= forbidden_for_.size()) forbidden_for_.resize(color + 1, k_none);
    forbidden_for_[color] = v;
  }
  bool forbidden(Index color, Index v) const {
    return color < forbidden_for_.size() && forbidden_for_[color] == v;
  }

 private:
  std::vector<Index> forbidden_for_;  // per colour, the last vertex that it was forbidden to
};

}  // namespace

std::vector<Index> Colorer::color_insides(const Pieces& pieces, ThreadPool& pool) {
  struct Outcome {
    std::vector<Index> rest;
    Index colors = 0;
  };
  std::vector<Outcome> outcomes(pieces.count());
  // Of each inner vertex, the new colours in its closed ring. 64 are enough but for odd positions.
  std::vector<std::uint64_t> seen(rings_.count(), 0);
  pool.for_ranges(pieces.count(), 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t p = first; p < last; ++p) {
      Outcome outcome;  // put into place at last: threads shall not share a line of cache
      for (const Index v : pieces.of(p)) {
        color_inside(v, static_cast<Index>(p), pieces, seen);
        if (colors_[v] == k_none) outcome.rest.push_back(v);
        outcome.colors = std::max(outcome.colors, colors_[v] + 1);  // 0 for k_none
      }
      outcomes[p] = std::move(outcome);
    }
  });
  std::vector<Index> rest;
  for (const Outcome& outcome : outcomes) {
    count_ = std::max(count_, outcome.colors);
    rest.insert(rest.end(), outcome.rest.begin(), outcome.rest.end());
  }
  return rest;
}

void Colorer::color_inside(Index v, Index piece, const Pieces& pieces,
                           std::vector<std::uint64_t>& seen) {
  std::uint64_t used = seen[v];
  for (const Index w : rings_.of(v)) {
    if (!is_inner(w)) continue;
    if (pieces.piece_of[w] != piece) return;
    used |= seen[w];
  }
  if (~used == 0) return;
  const int color = std::countr_one(used);
  seen[v] |= std::uint64_t{1} << color;
  for (const Index w : rings_.of(v)) {
    if (is_inner(w)) seen[w] |= std::uint64_t{1} << color;
  }
  colors_[v] = count_ + static_cast<Index>(color);
}

void Colorer::color_rest(std::span<const Index> vertices) {
  const Index base = count_;
  Palette palette;
  std::unordered_map<Index, UsedColors> hubs;
  std::vector<UsedColors*> near_hubs;
  const auto forbid_around = [&](Index w, Index v) {
    const auto forbid = [&](Index u) {
      if (colors_[u] != k_none && colors_[u] >= base) palette.forbid(colors_[u] - base, v);
    };
    if (rings_.of(w).size() > k_hub_valence) {
      near_hubs.push_back(&hubs[w]);
      return;
    }
    forbid(w);
    for (const Index u : rings_.of(w)) {
      if (is_inner(u)) forbid(u);
    }
  };
  for (const Index v : vertices) {
    near_hubs.clear();
    forbid_around(v, v);
    for (const Index w : rings_.of(v)) {
      if (is_inner(w)) forbid_around(w, v);
    }
    Index color = 0;
    for (const UsedColors* hub : near_hubs)
      color = std::max(color, hub->first_free());
    const auto is_used = [&](const UsedColors* hub) { return hub->uses(color); };
    while (palette.forbidden(color, v) || std::any_of(near_hubs.begin(), near_hubs.end(), is_used))
      ++color;
    colors_[v] = base + color;
    count_ = std::max(count_, base + color + 1);
    for (UsedColors* hub : near_hubs)
      hub->use(color);
  }
}

}  // namespace planish
