#include "mesh/repair/glue.h"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>

#include "mesh/disjoint_sets.h"
#include "mesh/edge_sides.h"
#include "mesh/repair/border_places.h"
#include "mesh/repair/sheets.h"
#include "mesh/turning_sets.h"

namespace planish {

namespace {

// Triangles at an edge lie on each other where the angle between them is below a degree.
constexpr double k_on_each_other = 0.99985;
// Edges too short for their numbers count too.
constexpr double k_least_weight = 1e-200;
// Pieces whose areas differ by less are as large as each other.
constexpr double k_even = 1e-9;

/// A border edge by the places of its ends.
struct PlacedEdge {
  Index low, high;  // places
  EdgeSide side;
  bool forward;  // its triangle goes from low to high

  auto key() const { return std::tie(low, high); }
};

/// Two border edges at the same places.
struct EdgePair {
  PlacedEdge one, other;
  double length;

  bool runs_same_way() const { return one.forward == other.forward; }
};

/// Pairs of edges that could be joined, and how many edges at one place could not.
struct EdgePairs {
  std::vector<EdgePair> pairs;
  std::size_t left = 0;
};

std::vector<PlacedEdge> placed_edges(const TriMesh& mesh, std::span<const Index> place) {
  std::vector<PlacedEdge> edges;
  for (const EdgeSide& side : border_sides(mesh)) {
    const Index from = place[side.forward ? side.low : side.high];
    const Index to = place[side.forward ? side.high : side.low];
    if (from != to) edges.push_back({std::min(from, to), std::max(from, to), side, from < to});
  }
  std::stable_sort(edges.begin(), edges.end(),
                   [](const PlacedEdge& a, const PlacedEdge& b) { return a.key() < b.key(); });
  return edges;
}

/// From the edge into its triangle, of unit length; 0 where that has no area.
Vec3 inward(const TriMesh& mesh, const EdgeSide& side) {
  const Triangle& corners = mesh.triangles[side.triangle];
  const Vec3 from = mesh.positions[side.low];
  const Vec3 edge = mesh.positions[side.high] - from;
  const Vec3 apex = mesh.positions[corners[(side.corner + 2) % 3]] - from;
  const Vec3 across = cross(cross(edge, apex), edge);
  const double length = norm(across);
  return length > 0.0 ? 1.0 / length * across : Vec3{};
}

EdgePairs pairs_of(const TriMesh& mesh, const std::vector<PlacedEdge>& edges) {
  EdgePairs result;
  for (std::size_t begin = 0; begin < edges.size();) {
    std::size_t end = begin;
    while (end < edges.size() && edges[end].key() == edges[begin].key())
      ++end;
    const PlacedEdge &one = edges[begin], &other = edges[end - 1];
    const bool fits = end - begin == 2 && one.side.triangle != other.side.triangle &&
                      dot(inward(mesh, one.side), inward(mesh, other.side)) < k_on_each_other;
    if (fits) {
      const double length = norm(mesh.positions[one.side.high] - mesh.positions[one.side.low]);
      result.pairs.push_back({one, other, length});
    } else if (end - begin > 1) {
      result.left += end - begin;
    }
    begin = end;
  }
  return result;
}

/// Two pieces that are to be joined: whether one of them must be turned.
struct Joint {
  Index one, other;
  double length = 0.0;    // of all edges between them
  double same_way = 0.0;  // of those that run the same way
};

std::vector<Joint> joints_of(const std::vector<EdgePair>& pairs, const Sheets& pieces) {
  std::vector<Joint> joints;
  for (const EdgePair& pair : pairs) {
    const auto [low, high] = std::minmax(pieces.of_triangle[pair.one.side.triangle],
                                         pieces.of_triangle[pair.other.side.triangle]);
    if (low == high) continue;
    const double weight = std::max(pair.length, k_least_weight);
    joints.push_back({low, high, weight, pair.runs_same_way() ? weight : 0.0});
  }
  const auto key = [](const Joint& joint) { return std::tie(joint.one, joint.other); };
  std::stable_sort(joints.begin(), joints.end(),
                   [&](const Joint& a, const Joint& b) { return key(a) < key(b); });
  std::vector<Joint> sums;
  for (const Joint& joint : joints) {
    if (sums.empty() || key(sums.back()) != key(joint)) {
      sums.push_back(joint);
      continue;
    }
    sums.back().length += joint.length;
    sums.back().same_way += joint.same_way;
  }
  std::sort(sums.begin(), sums.end(), [&](const Joint& a, const Joint& b) {
    return a.length != b.length ? a.length > b.length : key(a) < key(b);
  });
  return sums;
}

/// Of each piece whether it is turned: of pieces that hang together the smaller area is.
std::vector<unsigned char> pieces_to_turn(const TriMesh& mesh, const std::vector<EdgePair>& pairs,
                                          const Sheets& pieces) {
  TurningSets sets(pieces.count);
  for (const Joint& joint : joints_of(pairs, pieces))
    sets.join(joint.one, joint.other, 2.0 * joint.same_way > joint.length ? 1 : 0);
  const std::vector<double> areas = sums_over(pieces, unit_areas(mesh));
  std::vector<double> kept(pieces.count, 0.0), turned(pieces.count, 0.0);
  for (std::size_t p = 0; p < pieces.count; ++p) {
    const auto first = sets.first_of(static_cast<Index>(p));
    (first.turned != 0 ? turned : kept)[first.number] += areas[p];
  }
  std::vector<unsigned char> result(pieces.count, 0);
  for (std::size_t p = 0; p < pieces.count; ++p) {
    const auto first = sets.first_of(static_cast<Index>(p));
    const bool first_stays = turned[first.number] <= kept[first.number] * (1.0 + k_even);
    result[p] = (first.turned != 0) == first_stays ? 1 : 0;
  }
  return result;
}

/// Vertices joined by pairs of edges.
std::vector<Index> joined_vertices(const TriMesh& mesh, std::span<const Index> place,
                                   const std::vector<EdgePair>& pairs) {
  DisjointSets<Index> sets(mesh.positions.size());
  for (const EdgePair& pair : pairs) {
    const EdgeSide &a = pair.one.side, &b = pair.other.side;
    const bool same_ends = place[a.low] == place[b.low];
    sets.join(a.low, same_ends ? b.low : b.high);
    sets.join(a.high, same_ends ? b.high : b.low);
  }
  std::vector<Index> first;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v)
    first.push_back(sets.first_of(static_cast<Index>(v)));
  return first;
}

bool is_collapsed_or_turned(const TriMesh& mesh, const Triangle& before, const Triangle& after) {
  if (before == after) return false;
  const auto is_collapsed = [](const Triangle& t) {
    return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
  };
  if (is_collapsed(after)) return !is_collapsed(before);
  const auto normal = [&mesh](const Triangle& t) {
    return cross(mesh.positions[t[1]] - mesh.positions[t[0]],
                 mesh.positions[t[2]] - mesh.positions[t[0]]);
  };
  const Vec3 was = normal(before);
  return was != Vec3{} && !(dot(was, normal(after)) > 0.0);
}

/// Whether sides of the joined mesh may be one edge: they were one before, or two of them are a
/// pair that was joined.
bool is_sound(const EdgeSides& edge, const TriMesh& before,
              const std::vector<std::pair<Index, Index>>& glued) {
  const auto ends = [&before](const EdgeSide& side) {
    const Triangle& corners = before.triangles[side.triangle];
    return std::minmax(corners[side.corner], corners[(side.corner + 1) % 3]);
  };
  const auto were_one = [&](const EdgeSide& side) { return ends(side) == ends(*edge.begin); };
  if (std::all_of(edge.begin, edge.end, were_one)) return true;
  return edge.size() == 2 &&
         std::binary_search(glued.begin(), glued.end(),
                            std::pair(edge.begin[0].triangle, edge.begin[1].triangle));
}

/// The corners of triangles that have those of another one, as they had not before.
std::vector<Index> corners_of_twins(const TriMesh& before, const TriMesh& joined) {
  const auto corners_of = [](Triangle t) {
    std::sort(t.begin(), t.end());
    return t;
  };
  std::vector<std::pair<Triangle, Index>> keys;
  for (std::size_t t = 0; t < joined.triangles.size(); ++t)
    keys.emplace_back(corners_of(joined.triangles[t]), static_cast<Index>(t));
  std::sort(keys.begin(), keys.end());
  std::vector<Index> corners;
  for (std::size_t i = 1; i < keys.size(); ++i) {
    if (keys[i].first != keys[i - 1].first) continue;
    const Triangle &one = before.triangles[keys[i - 1].second],
                   &other = before.triangles[keys[i].second];
    if (corners_of(one) == corners_of(other)) continue;
    corners.insert(corners.end(), keys[i].first.begin(), keys[i].first.end());
  }
  return corners;
}

/// Marks vertices of the joined mesh at which it is not sound.
std::vector<unsigned char> unsound_vertices(const TriMesh& mesh, const std::vector<Index>& first,
                                            const std::vector<EdgePair>& pairs) {
  TriMesh joined = mesh;
  std::vector<unsigned char> unsound(mesh.positions.size(), 0);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (Index& v : joined.triangles[t])
      v = first[v];
    if (!is_collapsed_or_turned(mesh, mesh.triangles[t], joined.triangles[t])) continue;
    for (const Index v : joined.triangles[t])
      unsound[v] = 1;
  }
  for (const Index v : corners_of_twins(mesh, joined))
    unsound[v] = 1;
  std::vector<std::pair<Index, Index>> glued;
  glued.reserve(pairs.size());
  for (const EdgePair& pair : pairs) {
    const auto& [low, high] = std::minmax(pair.one.side.triangle, pair.other.side.triangle);
    glued.emplace_back(low, high);
  }
  std::sort(glued.begin(), glued.end());
  const std::vector<EdgeSide> sides = sorted_sides(joined);
  for (const EdgeSides& edge : group_by_edge(sides)) {
    if (is_sound(edge, mesh, glued)) continue;
    unsound[edge.begin->low] = unsound[edge.begin->high] = 1;
  }
  return unsound;
}

}  // namespace

Gluing find_gluing(const TriMesh& mesh, std::span<const Index> place) {
  const Sheets pieces = find_sheets(mesh);
  EdgePairs found = pairs_of(mesh, placed_edges(mesh, place));
  const std::vector<unsigned char> turned = pieces_to_turn(mesh, found.pairs, pieces);
  const auto leave = [&](const auto& is_wrong) {
    const auto removed = std::erase_if(found.pairs, is_wrong);
    found.left += 2 * removed;
    return removed > 0;
  };
  leave([&](const EdgePair& pair) {
    const bool turns_one = turned[pieces.of_triangle[pair.one.side.triangle]] !=
                           turned[pieces.of_triangle[pair.other.side.triangle]];
    return pair.runs_same_way() != turns_one;
  });
  // Nothing is joined at a vertex where the mesh would not be sound; what is left may be unsound
  // elsewhere. Every round leaves some pairs.
  std::vector<Index> first = joined_vertices(mesh, place, found.pairs);
  constexpr int k_rounds = 30;
  for (int round = 0; !found.pairs.empty(); ++round) {
    const std::vector<unsigned char> unsound = unsound_vertices(mesh, first, found.pairs);
    const bool changed = leave([&](const EdgePair& pair) {
      const EdgeSide& side = pair.one.side;
      return round == k_rounds || unsound[first[side.low]] != 0 || unsound[first[side.high]] != 0;
    });
    if (!changed || round == k_rounds) break;
    first = joined_vertices(mesh, place, found.pairs);
  }
  first = joined_vertices(mesh, place, found.pairs);
  Gluing gluing{std::move(first), std::vector<unsigned char>(mesh.triangles.size(), 0),
                found.pairs.size(), found.left, 0.0};
  // Those of which nothing was joined stay.
  const std::vector<unsigned char> stay_turned = pieces_to_turn(mesh, found.pairs, pieces);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    gluing.turned[t] = stay_turned[pieces.of_triangle[t]];
  for (const EdgePair& pair : found.pairs)
    gluing.length += pair.length;
  return gluing;
}

}  // namespace planish
