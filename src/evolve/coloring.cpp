#include "evolve/coloring.h"

#include <algorithm>
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

class Colorer {
 public:
  explicit Colorer(const Connectivity& connectivity)
      : connectivity_(connectivity), colors_(connectivity.vertex_count(), k_none) {
    for (const Index v : connectivity.inner_vertices()) {
      if (connectivity.ring(v).size() > k_hub_valence) hubs_.emplace(v, Hub{});
    }
  }

  void color(Index v) {
    near_hubs_.clear();
    forbid_around(v, v);
    for (const Index w : connectivity_.ring(v)) {
      if (connectivity_.is_inner(w)) forbid_around(w, v);
    }
    Index color = 0;
    for (const Hub* hub : near_hubs_)
      color = std::max(color, hub->first_free());
    while (forbidden(color, v))
      ++color;
    colors_[v] = color;
    for (Hub* hub : near_hubs_)
      hub->use(color);
  }

  std::vector<Index> finish() {
    std::replace(colors_.begin(), colors_.end(), k_none, Index{0});
    return std::move(colors_);
  }

 private:
  /// Forbids v the colours of w and of its inner neighbours.
  void forbid_around(Index w, Index v) {
    if (const auto hub = hubs_.find(w); hub != hubs_.end()) {
      near_hubs_.push_back(&hub->second);
      return;
    }
    forbid(colors_[w], v);
    for (const Index u : connectivity_.ring(w))
      forbid(colors_[u], v);
  }

  void forbid(Index color, Index v) {
    if (color == k_none) return;
    if (color >= forbidden_for_.size()) forbidden_for_.resize(color + 1, k_none);
    forbidden_for_[color] = v;
  }

  bool forbidden(Index color, Index v) const {
    if (color < forbidden_for_.size() && forbidden_for_[color] == v) return true;
    return std::any_of(near_hubs_.begin(), near_hubs_.end(),
                       [color](const Hub* hub) { return hub->uses(color); });
  }

  const Connectivity& connectivity_;
  std::vector<Index> colors_;
  std::vector<Index> forbidden_for_;  // per colour, the last vertex that it was forbidden to
  std::unordered_map<Index, Hub> hubs_;
  std::vector<Hub*> near_hubs_;
};

}  // namespace

std::vector<Index> distance_two_colors(const Connectivity& connectivity,
                                       std::span<const Index> order) {
  Colorer colorer(connectivity);
  for (const Index v : order)
    colorer.color(v);
  return colorer.finish();
}

}  // namespace planish
