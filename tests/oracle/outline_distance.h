#pragma once

// How far positions are from outlines, by trying every edge, and what tells whether outlines meet.

#include <algorithm>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include <planish/core/vec.h>

namespace planish::oracle {

using Loops = std::vector<std::vector<Vec2>>;

inline double distance_to_segment(Vec2 p, Vec2 a, Vec2 b) {
  const Vec2 edge = b - a;
  const double squared = dot(edge, edge);
  const double share = squared > 0.0 ? std::clamp(dot(p - a, edge) / squared, 0.0, 1.0) : 0.0;
  return norm(p - (a + share * edge));
}

inline double distance_to_outline(Vec2 p, const Loops& loops) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& loop : loops) {
    for (std::size_t i = 0; i < loop.size(); ++i)
      least = std::min(least, distance_to_segment(p, loop[i], loop[(i + 1) % loop.size()]));
  }
  return least;
}

/// By the rule of even and odd over all loops.
inline bool is_inside(Vec2 p, const Loops& loops) {
  bool inside = false;
  for (const auto& loop : loops) {
    for (std::size_t i = 0, j = loop.size() - 1; i < loop.size(); j = i++) {
      const Vec2 a = loop[i], b = loop[j];
      if ((a.y > p.y) == (b.y > p.y)) continue;
      if (p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
    }
  }
  return inside;
}

struct DistanceRange {
  double least = std::numeric_limits<double>::infinity(), most = 0.0;
};

/// Of the corners and positions between them of some lines from an outline.
inline DistanceRange distances(const Loops& lines, const Loops& outline, int places_an_edge = 3) {
  DistanceRange range;
  for (const auto& line : lines) {
    for (std::size_t i = 0; i < line.size(); ++i) {
      const Vec2 edge = line[(i + 1) % line.size()] - line[i];
      for (int k = 0; k < places_an_edge; ++k) {
        const double share = static_cast<double>(k) / places_an_edge;
        const double distance = distance_to_outline(line[i] + share * edge, outline);
        range = {std::min(range.least, distance), std::max(range.most, distance)};
      }
    }
  }
  return range;
}

/// Whether any two edges of some closed lines cross properly, by trying all pairs.
inline bool any_cross(const Loops& loops) {
  struct Edge {
    Vec2 a, b;
  };
  std::vector<Edge> edges;
  for (const auto& loop : loops) {
    for (std::size_t i = 0; i < loop.size(); ++i)
      edges.push_back({loop[i], loop[(i + 1) % loop.size()]});
  }
  const auto side = [](const Edge& e, Vec2 p) { return cross(e.b - e.a, p - e.a); };
  for (std::size_t i = 0; i < edges.size(); ++i) {
    for (std::size_t j = i + 1; j < edges.size(); ++j) {
      const Edge &e = edges[i], &f = edges[j];
      if (side(e, f.a) * side(e, f.b) < 0.0 && side(f, e.a) * side(f, e.b) < 0.0) return true;
    }
  }
  return false;
}

}  // namespace planish::oracle
