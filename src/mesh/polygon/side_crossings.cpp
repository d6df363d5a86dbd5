#include "mesh/polygon/side_crossings.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <set>
#include <tuple>
#include <vector>

#include "mesh/polygon/diagonal.h"

namespace planish {

namespace {

/// A side from its left end to its right one, and from below where it is upright.
struct Side {
  Vec2 left, right;
  std::size_t number;
};

bool is_left(Vec2 a, Vec2 b) {
  return std::tie(a.x, a.y) < std::tie(b.x, b.y);
}

bool cross_within(const Side& p, const Side& q) {
  return side_of(p.left, p.right, q.left) * side_of(p.left, p.right, q.right) < 0 &&
         side_of(q.left, q.right, p.left) * side_of(q.left, q.right, p.right) < 0;
}

/// The order from below of sides that a line meets, as long as none of them cross.
struct Below {
  bool operator()(const Side* p, const Side* q) const {
    const bool q_is_later = !is_left(q->left, p->left);
    const int side = q_is_later ? above(*p, *q) : -above(*q, *p);
    return side != 0 ? side > 0 : p->number < q->number;  // bridges lie on each other
  }

  /// Whether `later`, which begins no farther left, is above a side (1), below (-1) or on it (0).
  static int above(const Side& side, const Side& later) {
    const int at_begin = side_of(side.left, side.right, later.left);
    return at_begin != 0 ? at_begin : side_of(side.left, side.right, later.right);
  }
};

struct Event {
  Vec2 place;
  bool begins;
  std::size_t side;

  friend bool operator<(const Event& a, const Event& b) {
    return std::tie(a.place.x, a.place.y, a.begins, a.side) <
           std::tie(b.place.x, b.place.y, b.begins, b.side);
  }
};

}  // namespace

// Shamos and Hoey 1976: sides that cross are neighbours just before.
bool has_crossing_sides(std::span<const Vec2> polygon) {
  std::vector<Side> sides;
  std::vector<Event> events;
  sides.reserve(polygon.size());
  events.reserve(2 * polygon.size());
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vec2 a = polygon[k], b = polygon[(k + 1) % polygon.size()];
    if (a == b) continue;
    const bool forward = is_left(a, b);
    const Side& side = sides.emplace_back(Side{forward ? a : b, forward ? b : a, sides.size()});
    events.push_back({side.left, true, side.number});
    events.push_back({side.right, false, side.number});
  }
  std::sort(events.begin(), events.end());
  using Met = std::set<const Side*, Below>;
  Met met;
  std::vector<Met::iterator> place(sides.size());
  for (const Event& event : events) {
    if (event.begins) {
      const auto at = met.insert(&sides[event.side]).first;
      place[event.side] = at;
      const auto next = std::next(at);
      if (next != met.end() && cross_within(**at, **next)) return true;
      if (at != met.begin() && cross_within(**at, **std::prev(at))) return true;
    } else {
      const auto next = met.erase(place[event.side]);
      if (next != met.begin() && next != met.end() && cross_within(**next, **std::prev(next))) {
        return true;
      }
    }
  }
  return false;
}

}  // namespace planish
