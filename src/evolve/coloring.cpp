#include "evolve/coloring.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <unordered_map>

namespace planish {

namespace {

constexpr Index k_none = static_cast<Index>(-1);
/// Above this valence the colours around a vertex are kept in a set of their own: looking through
/// its ring again for each of its neighbours would take quadratic time.
constexpr std::size_t k_hub_valence = 64;

/// The colours in use around one vertex of high valence.
class Hub {
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
    if (color == k_none) return;
    if (color >= forbidden_for_.size()) forbidden_for_.resize(color + 1, k_none);
    forbidden_for_[color] = v;
  }
  bool forbidden(Index color, Index v) const {
    return color < forbidden_for_.size() && forbidden_for_[color] == v;
  }

 private:
  std::vector<Index> forbidden_for_;  // per colour, the last vertex that it was forbidden to
};

class Colorer {
 public:
  explicit Colorer(const InnerRings& rings) : rings_(rings), colors_(rings.count(), k_none) {
    for (std::size_t v = 0; v < rings.count(); ++v) {
      if (rings.of(v).size() > k_hub_valence) hubs_.emplace(static_cast<Index>(v), Hub{});
    }
  }

  bool is_inner(Index v) const { return v < colors_.size(); }

  /// Gives v the first colour that none has whose closed ring shares an inner vertex with that of
  /// v.
  void color(Index v, Palette& palette) {
    near_hubs_.clear();
    forbid_around(v, v, palette);
    for (const Index w : rings_.of(v)) {
      if (is_inner(w)) forbid_around(w, v, palette);
    }
    Index color = 0;
    for (const Hub* hub : near_hubs_)
      color = std::max(color, hub->first_free());
    while (palette.forbidden(color, v) || used_by_hub(color))
      ++color;
    colors_[v] = color;
    for (Hub* hub : near_hubs_)
      hub->use(color);
  }

  /// The same where all within two edges of v has a number from begin to end and no hub is near:
  /// then nothing outside of these is looked at. False where that is not so.
  bool color_inside(Index v, Index begin, Index end) {
    std::uint64_t used = 0;  // enough but for odd places
    if (!see_inside(v, begin, end, used)) return false;
    for (const Index w : rings_.of(v)) {
      if (is_inner(w) && !see_inside(w, begin, end, used)) return false;
    }
    if (~used == 0) return false;
    colors_[v] = static_cast<Index>(std::countr_one(used));
    return true;
  }

  bool is_colored(Index v) const { return colors_[v] != k_none; }
  std::vector<Index> finish() { return std::move(colors_); }

 private:
  /// Forbids v the colours of w and of its inner neighbours.
  void forbid_around(Index w, Index v, Palette& palette) {
    if (const auto hub = hubs_.find(w); hub != hubs_.end()) {
      near_hubs_.push_back(&hub->second);
      return;
    }
    palette.forbid(colors_[w], v);
    for (const Index u : rings_.of(w)) {
      if (is_inner(u)) palette.forbid(colors_[u], v);
    }
  }

  /// Adds the colours of w and of its inner neighbours to those used.
  bool see_inside(Index w, Index begin, Index end, std::uint64_t& used) const {
    const auto ring = rings_.of(w);
    if (ring.size() > k_hub_valence || w < begin || w >= end) return false;
    const auto bit = [this](Index u) {
      return static_cast<std::uint64_t>(colors_[u] < 64) << (colors_[u] & 63U);
    };
    used |= bit(w);
    for (const Index u : ring) {
      if (!is_inner(u)) continue;
      if (u < begin || u >= end) return false;
      used |= bit(u);
    }
    return true;
  }

  bool used_by_hub(Index color) const {
    return std::any_of(near_hubs_.begin(), near_hubs_.end(),
                       [color](const Hub* hub) { return hub->uses(color); });
  }

  const InnerRings& rings_;
  std::vector<Index> colors_;
  std::unordered_map<Index, Hub> hubs_;
  std::vector<Hub*> near_hubs_;
};

}  // namespace

std::vector<Index> distance_two_colors(const InnerRings& rings, ThreadPool& pool) {
  constexpr std::size_t piece = 8192;  // vertices; must not depend on the number of threads
  const std::size_t count = rings.count();
  Colorer colorer(rings);
  // What sees its own piece only can be coloured piece by piece at the same time.
  pool.for_ranges((count + piece - 1) / piece, 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t p = first; p < last; ++p) {
      const auto begin = static_cast<Index>(p * piece);
      const auto end = static_cast<Index>(std::min(count, (p + 1) * piece));
      for (Index v = begin; v < end; ++v)
        colorer.color_inside(v, begin, end);
    }
  });
  Palette palette;
  for (Index v = 0; v < count; ++v) {
    if (!colorer.is_colored(v)) colorer.color(v, palette);
  }
  return colorer.finish();
}

}  // namespace planish
