#include "mesh/repair/border_places.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>

namespace planish {

namespace {

constexpr double k_most_of_edge = 1.0 / 3.0;

/// Two places, the smaller number first.
struct NearPair {
  double square;
  Index one, other;

  bool operator<(const NearPair& pair) const {
    return std::tie(square, one, other) < std::tie(pair.square, pair.one, pair.other);
  }
};

/// Cells of all places of about one reach; they are twice as wide as it or wider.
struct CellEntry {
  int level;
  std::array<double, 3> cell;
  Index vertex;

  auto key() const { return std::tie(level, cell); }
};

int level_of(double reach) {
  int exponent = 0;
  std::frexp(reach, &exponent);
  return exponent + 1;
}

std::array<double, 3> cell_of(Vec3 p, int level) {
  const double size = std::ldexp(1.0, level);
  return {std::floor(p.x / size), std::floor(p.y / size), std::floor(p.z / size)};
}

/// Calls visit(entry) for all of a level that are within the reach of p, and for some others.
template <class Visit>
void for_each_near(const std::vector<CellEntry>& entries, int level, Vec3 p, double reach,
                   const Visit& visit) {
  const auto low = cell_of(p - Vec3{reach, reach, reach}, level);
  const auto high = cell_of(p + Vec3{reach, reach, reach}, level);
  for (unsigned corner = 0; corner < 8; ++corner) {
    CellEntry wanted{level, low, 0};
    bool is_new = true;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if ((corner >> axis & 1U) == 0) continue;
      wanted.cell[axis] = high[axis];
      is_new = is_new && high[axis] != low[axis];
    }
    if (!is_new) continue;
    auto at =
        std::lower_bound(entries.begin(), entries.end(), wanted,
                         [](const CellEntry& a, const CellEntry& b) { return a.key() < b.key(); });
    for (; at != entries.end() && at->key() == wanted.key(); ++at)
      visit(*at);
  }
}

/// Pairs within the reach of both.
std::vector<NearPair> near_pairs(const std::vector<Vec3>& positions,
                                 const std::vector<Index>& places,
                                 const std::vector<double>& reach) {
  std::vector<CellEntry> entries;
  std::vector<int> levels;
  for (const Index v : places) {
    if (!(reach[v] > 0.0)) continue;
    const int level = level_of(reach[v]);
    entries.push_back({level, cell_of(positions[v], level), v});
    levels.push_back(level);
  }
  std::sort(entries.begin(), entries.end(), [](const CellEntry& a, const CellEntry& b) {
    return std::tie(a.level, a.cell, a.vertex) < std::tie(b.level, b.cell, b.vertex);
  });
  std::sort(levels.begin(), levels.end());
  levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
  std::vector<NearPair> pairs;
  for (const CellEntry& entry : entries) {
    const Index v = entry.vertex;
    const auto offer = [&](const CellEntry& other) {
      const Index w = other.vertex;
      if (other.level == entry.level && w <= v) return;
      const Vec3 apart = positions[w] - positions[v];
      const double most = std::min(reach[v], reach[w]), square = dot(apart, apart);
      if (square <= most * most) pairs.push_back({square, std::min(v, w), std::max(v, w)});
    };
    for (auto level = std::lower_bound(levels.begin(), levels.end(), entry.level);
         level != levels.end(); ++level) {
      for_each_near(entries, *level, positions[v], reach[v], offer);
    }
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace

std::vector<Index> first_at_place(const std::vector<Vec3>& positions) {
  std::vector<Index> order(positions.size());
  std::iota(order.begin(), order.end(), Index{0});
  const auto place = [&](Index v) {
    const Vec3& p = positions[v];
    return std::tie(p.x, p.y, p.z);
  };
  std::sort(order.begin(), order.end(),
            [&](Index a, Index b) { return place(a) != place(b) ? place(a) < place(b) : a < b; });
  std::vector<Index> first(positions.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool same = i > 0 && place(order[i]) == place(order[i - 1]);
    first[order[i]] = same ? first[order[i - 1]] : order[i];
  }
  return first;
}

std::vector<EdgeSide> border_sides(const TriMesh& mesh) {
  const std::vector<EdgeSide> sides = sorted_sides(mesh);
  std::vector<EdgeSide> border;
  for (const EdgeSides& edge : group_by_edge(sides)) {
    if (edge.size() == 1 && edge.begin->low != edge.begin->high) border.push_back(*edge.begin);
  }
  return border;
}

BorderPlaces find_border_places(const TriMesh& mesh, const std::vector<EdgeSide>& border,
                                double length) {
  const std::size_t count = mesh.positions.size();
  constexpr double k_inside = std::numeric_limits<double>::infinity();
  std::vector<double> reach(count, k_inside);
  for (const EdgeSide& side : border) {
    const double edge = norm(mesh.positions[side.high] - mesh.positions[side.low]);
    for (const Index v : {side.low, side.high})
      reach[v] = std::min({reach[v], length, k_most_of_edge * edge});
  }
  // Of border vertices at equal places the smallest.
  BorderPlaces places{std::vector<Index>(count), std::move(reach)};
  const std::vector<Index> first = first_at_place(mesh.positions);
  std::vector<Index> smallest(count, static_cast<Index>(-1));
  std::vector<unsigned char> on_border(count, 0);
  for (const EdgeSide& side : border)
    on_border[side.low] = on_border[side.high] = 1;
  std::vector<Index> distinct;
  std::vector<std::vector<Index>> members(count);
  for (std::size_t i = 0; i < count; ++i) {
    const auto v = static_cast<Index>(i);
    places.of_vertex[v] = v;
    if (on_border[v] == 0) continue;
    Index& place = smallest[first[v]];
    if (place == static_cast<Index>(-1)) {
      place = v;
      distinct.push_back(v);
    }
    places.of_vertex[v] = place;
    places.reach[place] = std::min(places.reach[place], places.reach[v]);
    members[place].push_back(v);
  }
  for (const NearPair& pair : near_pairs(mesh.positions, distinct, places.reach)) {
    // Copies, as places change below.
    const std::pair<Index, Index> both =
        std::minmax({places.of_vertex[pair.one], places.of_vertex[pair.other]});
    const auto [low, high] = both;
    if (low == high) continue;
    const bool is_near =
        std::all_of(members[high].begin(), members[high].end(), [&, to = low](Index v) {
          return norm(mesh.positions[v] - mesh.positions[to]) <= places.reach[v];
        });
    if (!is_near) continue;
    for (const Index v : members[high])
      places.of_vertex[v] = low;
    members[low].insert(members[low].end(), members[high].begin(), members[high].end());
    members[high].clear();
  }
  return places;
}

}  // namespace planish
