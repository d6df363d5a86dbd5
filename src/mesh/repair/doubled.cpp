#include "mesh/repair/doubled.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <tuple>
#include <utility>

#include <planish/mesh/repair.h>

#include "mesh/edge_sides.h"
#include "mesh/repair/sheets.h"
#include "mesh/turning_sets.h"

namespace planish {

namespace {

constexpr Index k_none = static_cast<Index>(-1);

/// Corners in increasing order, and whether that is the orientation of the triangle.
std::pair<Triangle, bool> key_of(Triangle t) {
  std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  const bool rising = t[1] < t[2];
  if (!rising) std::swap(t[1], t[2]);
  return {t, rising};
}

TriMesh at_first_places(const TriMesh& mesh) {
  const std::vector<Index> first = first_at_place(mesh.positions);
  TriMesh result = mesh;
  for (Triangle& t : result.triangles) {
    for (Index& v : t)
      v = first[v];
  }
  return result;
}

/// Of each triangle the only other one with its corners, if that is oriented the other way.
std::vector<Index> opposites(const TriMesh& mesh, std::span<const unsigned char> gone) {
  struct Keyed {
    Triangle corners;
    bool rising;
    Index triangle;
  };
  std::vector<Keyed> keyed;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (gone[t] != 0) continue;
    const auto [corners, rising] = key_of(mesh.triangles[t]);
    if (corners[0] == corners[1] || corners[1] == corners[2]) continue;  // at one place
    keyed.push_back({corners, rising, static_cast<Index>(t)});
  }
  std::sort(keyed.begin(), keyed.end(), [](const Keyed& a, const Keyed& b) {
    return std::tie(a.corners, a.triangle) < std::tie(b.corners, b.triangle);
  });
  std::vector<Index> opposite(mesh.triangles.size(), k_none);
  for (std::size_t i = 0; i < keyed.size();) {
    std::size_t end = i;
    while (end < keyed.size() && keyed[end].corners == keyed[i].corners)
      ++end;
    if (end - i == 2 && keyed[i].rising != keyed[i + 1].rising) {
      opposite[keyed[i].triangle] = keyed[i + 1].triangle;
      opposite[keyed[i + 1].triangle] = keyed[i].triangle;
    }
    i = end;
  }
  return opposite;
}

/// Where every triangle of a piece has its opposite: in the same piece, or in others.
enum class Doubled : unsigned char { unknown, in_itself, by_others, no };

std::vector<Doubled> doubled_pieces(const Sheets& pieces, const std::vector<Index>& opposite,
                                    std::span<const unsigned char> gone) {
  std::vector<Doubled> doubled(pieces.count, Doubled::unknown);
  for (std::size_t t = 0; t < opposite.size(); ++t) {
    if (gone[t] != 0) continue;
    Doubled& piece = doubled[pieces.of_triangle[t]];
    const Doubled here = opposite[t] == k_none ? Doubled::no
                         : pieces.of_triangle[opposite[t]] == pieces.of_triangle[t]
                             ? Doubled::in_itself
                             : Doubled::by_others;
    piece = piece == Doubled::unknown || piece == here ? here : Doubled::no;
  }
  return doubled;
}

/// In a piece that has both sides: of each pair of opposite triangles the one that agrees with the
/// first triangle of the piece.
void add_backs_within(const TriMesh& mesh, const std::vector<Index>& opposite,
                      const std::vector<unsigned char>& wanted, std::vector<Index>& backs) {
  std::vector<unsigned char> skipped(mesh.triangles.size(), 1);
  for (std::size_t t = 0; t < skipped.size(); ++t) {
    if (wanted[t] != 0 && t < opposite[t]) skipped[t] = 0;
  }
  const std::vector<EdgeSide> sides = sorted_sides(mesh, skipped);
  TurningSets sets(mesh.triangles.size());
  for (const EdgeSides& edge : group_by_edge(sides)) {
    if (edge.size() != 2) continue;
    const EdgeSide &a = edge.begin[0], &b = edge.begin[1];
    sets.join(a.triangle, b.triangle, a.forward == b.forward ? 1 : 0);
  }
  for (std::size_t t = 0; t < skipped.size(); ++t) {
    if (skipped[t] != 0) continue;
    const auto number = static_cast<Index>(t);
    backs.push_back(sets.first_of(number).turned != 0 ? number : opposite[t]);
  }
}

/// Of pieces that double each other those that come later; of no pair of opposite triangles both.
void add_backs_of_others(const Sheets& pieces, const std::vector<Index>& opposite,
                         const std::vector<Doubled>& doubled, std::vector<Index>& backs) {
  enum class Fate : unsigned char { open, front, back };
  std::vector<Fate> fate(pieces.count, Fate::open);
  std::vector<std::vector<Index>> members(pieces.count);
  for (std::size_t t = 0; t < opposite.size(); ++t) {
    if (doubled[pieces.of_triangle[t]] == Doubled::by_others)
      members[pieces.of_triangle[t]].push_back(static_cast<Index>(t));
  }
  for (std::size_t p = 0; p < pieces.count; ++p) {
    const auto is_back = [&](Index t) {
      return fate[pieces.of_triangle[opposite[t]]] == Fate::front;
    };
    if (fate[p] != Fate::open || members[p].empty()) continue;
    const bool is_doubled_by_front = std::all_of(members[p].begin(), members[p].end(), is_back);
    fate[p] = is_doubled_by_front ? Fate::back : Fate::front;
    if (is_doubled_by_front) backs.insert(backs.end(), members[p].begin(), members[p].end());
  }
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

bool has_equal_places(const TriMesh& mesh) {
  const std::vector<Index> first = first_at_place(mesh.positions);
  for (std::size_t v = 0; v < first.size(); ++v) {
    if (first[v] != v) return true;
  }
  return false;
}

std::vector<Index> backs_of_doubled_sheets(const TriMesh& mesh,
                                           std::span<const unsigned char> gone) {
  const TriMesh placed = at_first_places(mesh);
  const std::vector<Index> opposite = opposites(placed, gone);
  const std::vector<EdgeSide> sides = sorted_sides(mesh, gone);
  const Sheets pieces = find_sheets(mesh.triangles.size(), group_by_edge(sides));
  const std::vector<Doubled> doubled = doubled_pieces(pieces, opposite, gone);
  std::vector<unsigned char> in_itself(mesh.triangles.size(), 0);
  for (std::size_t t = 0; t < in_itself.size(); ++t)
    in_itself[t] = doubled[pieces.of_triangle[t]] == Doubled::in_itself ? 1 : 0;
  std::vector<Index> backs;
  add_backs_within(placed, opposite, in_itself, backs);
  add_backs_of_others(pieces, opposite, doubled, backs);
  std::sort(backs.begin(), backs.end());
  return backs;
}

}  // namespace planish
