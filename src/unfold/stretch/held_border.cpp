#include "unfold/stretch/held_border.h"

#include <algorithm>
#include <array>
#include <utility>

#include "solve/dissection.h"

namespace planish {

namespace {

std::vector<TurnBending::Turn> turns_of(const Disk& disk, const BorderLengths& lengths) {
  constexpr double k_shortest = 0.05;  // of the mean
  const std::size_t n = disk.border.size();
  double total = 0.0;
  for (const double length : lengths.of_edges)
    total += length;
  const double shortest = k_shortest * total / static_cast<double>(n);
  std::vector<TurnBending::Turn> turns;
  for (std::size_t k = 0; k < n; ++k) {
    // The edge that ends here, and the vertex it is from.
    const std::size_t before = disk.loops.previous(k);
    const double least = std::min(lengths.of_edges[before], lengths.of_edges[k]);
    if (!(least > shortest) || (lengths.may_change(before) && lengths.may_change(k))) continue;
    const double length = 0.5 * (lengths.of_edges[before] + lengths.of_edges[k]);
    turns.push_back({{disk.border[before], disk.border[k], disk.border[disk.loops.next(k)]},
                     HeldBorder::k_stiffness / length});
  }
  return turns;
}

/// Of vertices that share a triangle or a turn.
Graph graph_of(const Disk& disk, const TurnBending& bend) {
  std::vector<std::array<Index, 2>> pairs;
  pairs.reserve(6 * (disk.triangles.size() + bend.turns().size()));
  const auto add = [&](const Triangle& t) {
    for (int k = 0; k < 3; ++k) {
      const Index v = t[k], w = t[(k + 1) % 3];
      pairs.push_back({v, w});
      pairs.push_back({w, v});
    }
  };
  for (const Triangle& t : disk.triangles)
    add(t);
  for (const TurnBending::Turn& turn : bend.turns())
    add(turn.vertices);
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  Graph graph;
  graph.start.assign(disk.vertex_count + 1, 0);
  graph.neighbours.reserve(pairs.size());
  for (const auto& [v, w] : pairs) {
    ++graph.start[v + 1];
    graph.neighbours.push_back(w);
  }
  for (std::size_t v = 0; v < disk.vertex_count; ++v)
    graph.start[v + 1] += graph.start[v];
  return graph;
}

std::vector<Vec3> in_space(const std::vector<Vec2>& flat) {
  std::vector<Vec3> positions;
  positions.reserve(flat.size());
  for (const Vec2 p : flat)
    positions.push_back({p.x, p.y, 0.0});
  return positions;
}

}  // namespace

HeldBorder::HeldBorder(const Disk& disk, BorderLengths wanted, const std::vector<Vec2>& like)
    : lengths(std::move(wanted)),
      bend(turns_of(disk, lengths), like),
      order(nested_dissection(in_space(like), graph_of(disk, bend))) {}

}  // namespace planish
