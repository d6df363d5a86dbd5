#include "mesh/polygon/ear_clipping.h"

#include <array>
#include <limits>
#include <queue>
#include <tuple>

#include "mesh/polygon/diagonal.h"
#include "mesh/polygon/plane_grid.h"

namespace planish {

namespace {

constexpr Index k_none = std::numeric_limits<Index>::max();

class EarClipper {
 public:
  explicit EarClipper(std::span<const Vec2> places)
      : places_(places),
        grid_(places),
        cells_(grid_.cell_count()),
        previous_(places.size()),
        next_(places.size()),
        stamp_(places.size(), 0),
        in_way_(places.size(), 0),
        waiting_(places.size()) {}

  std::optional<std::vector<Triangle>> clip() {
    link();
    std::size_t left = places_.size();
    triangles_.reserve(left - 2);
    while (left > 3) {
      if (queue_.empty()) return std::nullopt;
      const Candidate best = queue_.top();
      queue_.pop();
      if (best.stamp != stamp_[best.corner]) continue;  // its neighbours are others by now
      if (!is_flat(best.corner)) {
        if (!sees_within(best.corner)) continue;
        const Index blocking = corner_in(best.corner);
        if (blocking != k_none) {
          waiting_[blocking].push_back(best.corner);
          continue;
        }
      }
      cut_off(best.corner);
      --left;
    }
    return finish();
  }

 private:
  struct Candidate {
    double length;  // of the cut, squared
    Index corner;
    Index stamp;

    friend bool operator>(const Candidate& a, const Candidate& b) {
      return std::tie(a.length, a.corner, a.stamp) > std::tie(b.length, b.corner, b.stamp);
    }
  };

  Vec2 at(Index corner) const { return places_[corner]; }
  int turn(Index corner) const {
    return side_of(at(previous_[corner]), at(corner), at(next_[corner]));
  }

  void link() {
    const auto n = static_cast<Index>(places_.size());
    for (Index k = 0; k < n; ++k) {
      previous_[k] = k == 0 ? n - 1 : k - 1;
      next_[k] = k + 1 == n ? 0 : k + 1;
    }
    for (Index k = 0; k < n; ++k) {
      if (turn(k) <= 0) {
        in_way_[k] = 1;
        cells_[grid_.cell(at(k))].push_back(k);
      }
      offer(k);
    }
  }

  /// Whether the corner lies on the next one: nothing is cut off with it.
  bool is_flat(Index corner) const { return at(corner) == at(next_[corner]); }

  void offer(Index corner) {
    ++stamp_[corner];
    if (turn(corner) <= 0 && !is_flat(corner)) return;
    const Vec2 cut = at(next_[corner]) - at(previous_[corner]);
    queue_.push({is_flat(corner) ? -1.0 : dot(cut, cut), corner, stamp_[corner]});
  }

  /// Whether the cut begins and ends between the sides of the corners beside it. Of a polygon
  /// without bridges that would follow from no corner being in the way.
  bool sees_within(Index corner) const {
    const Index a = previous_[corner], c = next_[corner];
    const auto turns_left = [&](Index p, Index q, Index r) {
      return side_of(at(p), at(q), at(r)) > 0;
    };
    return (!turns_left(previous_[a], a, corner) || turns_left(previous_[a], a, c)) &&
           (!turns_left(corner, c, next_[c]) || turns_left(a, c, next_[c]));
  }

  /// A corner that lies in the triangle of an ear or on its sides; none where it can be cut off.
  Index corner_in(Index corner) const {
    const std::array ear = {at(previous_[corner]), at(corner), at(next_[corner])};
    Index found = k_none;
    grid_.visit(ear, [&](std::size_t cell) {
      for (const Index k : cells_[cell]) {
        const Vec2 p = at(k);
        if (p == ear[0] || p == ear[1] || p == ear[2]) continue;
        if (side_of(ear[2], ear[0], p) < 0 || side_of(ear[0], ear[1], p) < 0 ||
            side_of(ear[1], ear[2], p) < 0)
          continue;
        found = k;
        return true;
      }
      return false;
    });
    return found;
  }

  void cut_off(Index corner) {
    const Index a = previous_[corner], c = next_[corner];
    triangles_.push_back({a, corner, c});
    next_[a] = c;
    previous_[c] = a;
    ++stamp_[corner];
    clear_way(corner);
    for (const Index k : {a, c}) {
      if (turn(k) > 0) clear_way(k);
      offer(k);
    }
  }

  /// The corner is in no ear's way any more.
  void clear_way(Index corner) {
    if (in_way_[corner] == 0) return;
    in_way_[corner] = 0;
    std::vector<Index>& cell = cells_[grid_.cell(at(corner))];
    for (Index& k : cell) {
      if (k != corner) continue;
      k = cell.back();
      cell.pop_back();
      break;
    }
    std::vector<Index> waiting;
    waiting.swap(waiting_[corner]);
    for (const Index k : waiting) {
      // What was cut off meanwhile has no neighbours that know it.
      if (next_[previous_[k]] == k && previous_[next_[k]] == k) offer(k);
    }
  }

  std::optional<std::vector<Triangle>> finish() {
    Index b = 0;
    while (next_[previous_[b]] != b || previous_[next_[b]] != b)
      ++b;
    if (turn(b) <= 0 && !is_flat(b) && !is_flat(next_[b]) && !is_flat(previous_[b])) {
      return std::nullopt;
    }
    triangles_.push_back({previous_[b], b, next_[b]});
    return std::move(triangles_);
  }

  std::span<const Vec2> places_;
  PlaneGrid grid_;
  std::vector<std::vector<Index>> cells_;  // corners that may be in the way of an ear
  std::vector<Index> previous_, next_;
  std::vector<Index> stamp_;
  std::vector<unsigned char> in_way_;
  std::vector<std::vector<Index>> waiting_;  // ears that a corner is in the way of
  std::priority_queue<Candidate, std::vector<Candidate>, std::greater<>> queue_;
  std::vector<Triangle> triangles_;
};

}  // namespace

std::optional<std::vector<Triangle>> clip_ears(std::span<const Vec2> places) {
  return EarClipper(places).clip();
}

}  // namespace planish
