#include "pattern/polygon/free_strip.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "pattern/polygon/polygon_rays.h"

namespace planish {

namespace {

constexpr int k_lines_a_side = 20;

struct Interval {
  double low, high;
};

/// A place by its way along the strip's direction and to the left of it.
struct Frame {
  Vec2 direction;
  Vec2 of(Vec2 p) const { return {dot(direction, p), cross(direction, p)}; }
  Vec2 place(Vec2 q) const {
    return {q.x * direction.x - q.y * direction.y, q.x * direction.y + q.y * direction.x};
  }
};

/// What an edge takes up of the strip with |y| <= half_width about y = middle.
std::optional<Interval> taken_by(Vec2 a, Vec2 b, double middle, double half_width) {
  const double low = middle - half_width, high = middle + half_width;
  if (std::max(a.y, b.y) < low || std::min(a.y, b.y) > high) return std::nullopt;
  const auto x_at = [&](double y) {
    const double share = a.y == b.y ? 0.0 : std::clamp((y - a.y) / (b.y - a.y), 0.0, 1.0);
    return a.x + share * (b.x - a.x);
  };
  if (a.y == b.y) return Interval{std::min(a.x, b.x), std::max(a.x, b.x)};
  const double at_low = x_at(low), at_high = x_at(high);
  return Interval{std::min(at_low, at_high), std::max(at_low, at_high)};
}

std::vector<Interval> taken(std::span<const Polygon> framed, double middle, double half_width) {
  std::vector<Interval> intervals;
  for (const Polygon& loop : framed) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const auto some = taken_by(loop[i], loop[(i + 1) % loop.size()], middle, half_width);
      if (some) intervals.push_back(*some);
    }
  }
  std::sort(intervals.begin(), intervals.end(),
            [](Interval a, Interval b) { return a.low < b.low; });
  return intervals;
}

/// The longest free part of one line, in the frame.
FreeStrip longest_on_line(std::span<const Polygon> framed, double middle, double half_width) {
  FreeStrip best;
  double reached = std::numeric_limits<double>::infinity();
  for (const Interval next : taken(framed, middle, half_width)) {
    const Vec2 centre{0.5 * (reached + next.low), middle};
    if (next.low - reached > best.length && is_within(framed, centre)) {
      best = {centre, next.low - reached};
    }
    reached = std::isfinite(reached) ? std::max(reached, next.high) : next.high;
  }
  return best;
}

}  // namespace

FreeStrip longest_strip(std::span<const Polygon> loops, Vec2 direction, double half_width,
                        double enough) {
  const Frame frame{direction};
  std::vector<Polygon> framed(loops.begin(), loops.end());
  for (Polygon& loop : framed) {
    for (Vec2& p : loop)
      p = frame.of(p);
  }
  const auto lower = [](Vec2 a, Vec2 b) { return a.y < b.y; };
  const auto [low, high] = std::minmax_element(framed.front().begin(), framed.front().end(), lower);
  const double middle = 0.5 * (low->y + high->y);
  const double step = 0.5 * (high->y - low->y) / (k_lines_a_side + 1);
  FreeStrip best;
  for (int line = 0; line <= 2 * k_lines_a_side; ++line) {
    // From the middle outwards: 0, 1, -1, 2, -2, ...
    const int place = line % 2 == 1 ? (line + 1) / 2 : -line / 2;
    const FreeStrip some = longest_on_line(framed, middle + place * step, half_width);
    if (std::min(some.length, enough) > best.length) {
      best = {some.middle, std::min(some.length, enough)};
    }
  }
  return {frame.place(best.middle), best.length};
}

}  // namespace planish
