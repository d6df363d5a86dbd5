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
  explicit Colorer(const Connectivity& connectivity)
      : connectivity_(connectivity), colors_(connectivity.vertex_count(), k_none) {
    for (const Index v : connectivity.inner_vertices()) {
      if (connectivity.ring(v).size() > k_hub_valence) hubs_.emplace(v, Hub{});
    }
  }

  bool is_hub(Index v) const { return !hubs_.empty() && hubs_.count(v) > 0; }

  /// Gives v the first colour that none has whose closed ring shares an inner vertex with that of
  /// v.
  void color(Index v, Palette& palette) {
    near_hubs_.clear();
    forbid_around(v, v, palette);
    for (const Index w : connectivity_.ring(v)) {
      if (connectivity_.is_inner(w)) forbid_around(w, v, palette);
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

  /// The same where no hub is near; then what it looks at is within two edges of v.
  void color_away_from_hubs(Index v, Palette& palette) {
    forbid_ring(v, v, palette);
    for (const Index w : connectivity_.ring(v)) {
      if (connectivity_.is_inner(w)) forbid_ring(w, v, palette);
    }
    Index color = 0;
    while (palette.forbidden(color, v))
      ++color;
    colors_[v] = color;
  }

  std::vector<Index> finish() {
    std::replace(colors_.begin(), colors_.end(), k_none, Index{0});
    return std::move(colors_);
  }

 private:
  /// Forbids v the colours of w and of its inner neighbours.
  void forbid_around(Index w, Index v, Palette& palette) {
    if (const auto hub = hubs_.find(w); hub != hubs_.end()) {
      near_hubs_.push_back(&hub->second);
      return;
    }
    forbid_ring(w, v, palette);
  }

  void forbid_ring(Index w, Index v, Palette& palette) const {
    palette.forbid(colors_[w], v);
    for (const Index u : connectivity_.ring(w))
      palette.forbid(colors_[u], v);
  }

  bool used_by_hub(Index color) const {
    return std::any_of(near_hubs_.begin(), near_hubs_.end(),
                       [color](const Hub* hub) { return hub->uses(color); });
  }

  const Connectivity& connectivity_;
  std::vector<Index> colors_;
  std::unordered_map<Index, Hub> hubs_;
  std::vector<Hub*> near_hubs_;
};

/// Cuts the order into pieces and tells which vertices see no other piece, and no hub.
class Pieces {
 public:
  Pieces(const Connectivity& connectivity, std::span<const Index> order, const Colorer& colorer,
         ThreadPool& pool)
      : connectivity_(connectivity), piece_of_(connectivity.vertex_count(), k_none) {
    pool.for_ranges(order.size(), k_piece, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        piece_of_[order[i]] = static_cast<Index>(i / k_piece);
    });
    mixed_.resize(connectivity.vertex_count(), 0);
    pool.for_ranges(order.size(), k_piece, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        mixed_[order[i]] = colorer.is_hub(order[i]) || sees_two_pieces(order[i]) ? 1 : 0;
    });
  }

  static std::size_t count(std::size_t vertices) { return (vertices + k_piece - 1) / k_piece; }
  static std::size_t begin(std::size_t piece) { return piece * k_piece; }

  /// True if all within two edges of v, over inner vertices, is of its piece.
  bool is_inside(Index v) const {
    const auto ring = connectivity_.ring(v);
    return mixed_[v] == 0 &&
           std::none_of(ring.begin(), ring.end(), [this](Index w) { return mixed_[w] != 0; });
  }

 private:
  static constexpr std::size_t k_piece = 8192;

  bool sees_two_pieces(Index v) const {
    const auto ring = connectivity_.ring(v);
    return std::any_of(ring.begin(), ring.end(), [&](Index w) {
      return piece_of_[w] != k_none && piece_of_[w] != piece_of_[v];
    });
  }

  const Connectivity& connectivity_;
  std::vector<Index> piece_of_;
  std::vector<unsigned char> mixed_;
};

}  // namespace

std::vector<Index> distance_two_colors(const Connectivity& connectivity,
                                       std::span<const Index> order, ThreadPool& pool) {
  Colorer colorer(connectivity);
  const Pieces pieces(connectivity, order, colorer, pool);
  // What sees its own piece only can be coloured piece by piece at the same time.
  pool.for_ranges(Pieces::count(order.size()), 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t p = first; p < last; ++p) {
      Palette palette;
      const std::size_t end = std::min(order.size(), Pieces::begin(p + 1));
      for (std::size_t i = Pieces::begin(p); i < end; ++i) {
        if (pieces.is_inside(order[i])) colorer.color_away_from_hubs(order[i], palette);
      }
    }
  });
  Palette palette;
  for (const Index v : order) {
    if (!pieces.is_inside(v)) colorer.color(v, palette);
  }
  return colorer.finish();
}

}  // namespace planish
