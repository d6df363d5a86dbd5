#include "mesh/polygon/delaunay_flips.h"

#include <algorithm>
#include <array>
#include <limits>

#include "mesh/polygon/diagonal.h"

namespace planish {

namespace {

constexpr Index k_outside = std::numeric_limits<Index>::max();

/// A polygon that grows ear by ear; its diagonals are flipped after each. The ears were cut from
/// small to large, so few flips follow from one of them.
class FlippedTriangles {
 public:
  FlippedTriangles(std::span<const Vec2> places, std::span<const Index> numbers)
      : places_(places), numbers_(numbers), inside_(places.size(), k_outside) {
    flips_left_ = k_most_flips * places.size();
  }

  void begin(const Triangle& rest) {
    parts_.push_back({rest, {k_outside, k_outside, k_outside}});
    for (const Index corner : rest)
      inside_[corner] = 0;
  }

  void add(const Triangle& ear) {
    const auto [a, tip, c] = ear;
    const Index t = inside_[a];
    const auto added = static_cast<Index>(parts_.size());
    parts_.push_back({ear, {k_outside, k_outside, t}});
    parts_[t].across[slot_of(t, a)] = added;
    inside_[a] = added;
    inside_[tip] = added;
    open_.push_back({added, t});
    settle(Diagonal::through_second);
  }

  /// Decides ties, once all ears are back.
  void decide_ties() {
    for (Index t = 0; t < parts_.size(); ++t)
      for (const Index other : parts_[t].across)
        if (other != k_outside && t < other) open_.push_back({t, other});
    settle(Diagonal::either);
  }

  std::vector<Triangle> take() const {
    std::vector<Triangle> triangles;
    triangles.reserve(parts_.size());
    for (const Part& part : parts_)
      triangles.push_back(part.corners);
    return triangles;
  }

 private:
  /// Far beyond what polygons need: rounding alone could let flips go round.
  static constexpr std::size_t k_most_flips = 1000;

  struct Part {
    Triangle corners;
    std::array<Index, 3> across;  ///< the triangle beyond the side from this corner to the next
  };

  std::size_t slot_of(Index t, Index corner) const {
    const Triangle& corners = parts_[t].corners;
    return corners[0] == corner ? 0 : corners[1] == corner ? 1 : 2;
  }

  /// Two triangles and the diagonal between them.
  struct Pair {
    Index t, u;
  };

  void settle(Diagonal kind) {
    while (!open_.empty()) {
      const Pair pair = open_.back();
      open_.pop_back();
      const auto& across = parts_[pair.t].across;
      const auto side = std::find(across.begin(), across.end(), pair.u);
      if (side == across.end() || flips_left_ == 0) continue;  // another flip came before
      try_flip(pair, static_cast<std::size_t>(side - across.begin()), kind);
    }
  }

  /// Flips the diagonal from a to b, with c to its left in t and d to its right in u.
  void try_flip(Pair pair, std::size_t side, Diagonal kind) {
    const auto [t, u] = pair;
    const Part left = parts_[t];
    const Index a = left.corners[side], b = left.corners[(side + 1) % 3],
                c = left.corners[(side + 2) % 3];
    const std::size_t slot = slot_of(u, b);
    const Part right = parts_[u];
    const Index d = right.corners[(slot + 2) % 3];
    const std::array<Vec2, 4> quad = {places_[a], places_[d], places_[b], places_[c]};
    if (better_diagonal(quad) != kind) return;
    if (kind == Diagonal::either &&
        std::min(numbers_[c], numbers_[d]) >= std::min(numbers_[a], numbers_[b]))
      return;
    if (side_of(quad[3], quad[0], quad[1]) <= 0 || side_of(quad[1], quad[2], quad[3]) <= 0) return;
    const Index beyond_ad = right.across[(slot + 1) % 3], beyond_db = right.across[(slot + 2) % 3];
    const Index beyond_bc = left.across[(side + 1) % 3], beyond_ca = left.across[(side + 2) % 3];
    parts_[t] = {{a, d, c}, {beyond_ad, u, beyond_ca}};
    parts_[u] = {{d, b, c}, {beyond_db, beyond_bc, t}};
    replace(beyond_ad, a, u, t);
    replace(beyond_bc, b, t, u);
    --flips_left_;
    for (const Index beyond : {beyond_ad, beyond_ca})
      if (beyond != k_outside) open_.push_back({t, beyond});
    for (const Index beyond : {beyond_db, beyond_bc})
      if (beyond != k_outside) open_.push_back({u, beyond});
  }

  /// The side from a corner on has `now` inside in place of `before`.
  void replace(Index beyond, Index corner, Index before, Index now) {
    if (beyond == k_outside) {
      inside_[corner] = now;
    } else {
      std::replace(parts_[beyond].across.begin(), parts_[beyond].across.end(), before, now);
    }
  }

  std::span<const Vec2> places_;
  std::span<const Index> numbers_;
  std::vector<Part> parts_;
  std::vector<Index> inside_;  // the triangle at the side of the border from this corner on
  std::vector<Pair> open_;
  std::size_t flips_left_;
};

}  // namespace

std::vector<Triangle> delaunay_triangles(std::span<const Vec2> places,
                                         std::span<const Index> numbers,
                                         std::span<const Triangle> ears) {
  FlippedTriangles triangles(places, numbers);
  triangles.begin(ears.back());
  for (std::size_t k = ears.size() - 1; k > 0; --k)
    triangles.add(ears[k - 1]);
  triangles.decide_ties();
  return triangles.take();
}

}  // namespace planish
