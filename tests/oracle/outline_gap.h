#pragma once

// How far outlines are apart, by trying every corner against every edge.

#include <cmath>

#include "oracle/outline_distance.h"

namespace planish::oracle {

struct OutlineBox {
  Vec2 low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  Vec2 high{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
};

inline OutlineBox outline_box(const Loops& loops) {
  OutlineBox box;
  for (const auto& loop : loops) {
    for (const Vec2 p : loop) {
      box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
      box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
    }
  }
  return box;
}

constexpr double k_gap_rounding = 1e-6;  // millimetres: what meets by less only touches

inline bool edges_cross(const Loops& a, const Loops& b) {
  // How far r and s are on two sides of the line through p and q, of the nearer one.
  const auto reach_over = [](Vec2 p, Vec2 q, Vec2 r, Vec2 s) {
    const double one = cross(q - p, r - p), other = cross(q - p, s - p);
    if (one * other >= 0.0) return 0.0;
    return std::min(std::abs(one), std::abs(other)) / norm(q - p);
  };
  for (const auto& one : a) {
    for (std::size_t i = 0; i < one.size(); ++i) {
      const Vec2 p = one[i], q = one[(i + 1) % one.size()];
      for (const auto& other : b) {
        for (std::size_t j = 0; j < other.size(); ++j) {
          const Vec2 r = other[j], s = other[(j + 1) % other.size()];
          if (std::min(reach_over(p, q, r, s), reach_over(r, s, p, q)) > k_gap_rounding)
            return true;
        }
      }
    }
  }
  return false;
}

/// The least distance of two areas; negative where they have more than their borders in common.
/// Areas whose boxes are farther apart than `enough` are told to be `enough` apart.
inline double gap_between(const Loops& a, const Loops& b, double enough) {
  const OutlineBox p = outline_box(a), q = outline_box(b);
  const double apart =
      std::max({p.low.x - q.high.x, q.low.x - p.high.x, p.low.y - q.high.y, q.low.y - p.high.y});
  if (apart > enough) return enough;
  if (edges_cross(a, b)) return -1.0;
  double least = enough;
  for (const auto& [corners, outline] : {std::pair(&a, &b), std::pair(&b, &a)}) {
    for (const auto& loop : *corners) {
      for (const Vec2 corner : loop) {
        const double distance = distance_to_outline(corner, *outline);
        if (distance > k_gap_rounding && is_inside(corner, *outline)) return -1.0;
        least = std::min(least, distance);
      }
    }
  }
  return least;
}

}  // namespace planish::oracle
