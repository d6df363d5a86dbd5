#include "mesh/manifold_defects.h"

#include <algorithm>
#include <numeric>
#include <string>
#include <utility>

#include "mesh/edge_sides.h"
#include "mesh/turning_sets.h"

namespace planish {

namespace {

std::string number(std::size_t n) {
  return std::to_string(n);
}

void find_repeated_indices(const TriMesh& mesh, std::vector<unsigned char>& skipped,
                           std::vector<Problem>& problems) {
  std::size_t count = 0, first = 0;
  for (std::size_t t = mesh.triangles.size(); t-- > 0;) {
    const Triangle& tri = mesh.triangles[t];
    if (tri[0] != tri[1] && tri[1] != tri[2] && tri[2] != tri[0]) continue;
    skipped[t] = 1;
    ++count;
    first = t;
  }
  if (count == 0) return;
  problems.push_back({ErrorCode::repeated_index,
                      number(count) + (count == 1 ? " triangle names" : " triangles name") +
                          " a vertex twice; the first is triangle " + number(first) + ": remove it",
                      count, first});
}

void find_duplicates(const TriMesh& mesh, std::vector<unsigned char>& skipped,
                     std::vector<Problem>& problems) {
  std::vector<std::pair<Triangle, Index>> keys;
  keys.reserve(mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (skipped[t] != 0) continue;
    Triangle key = mesh.triangles[t];
    std::sort(key.begin(), key.end());
    keys.emplace_back(key, static_cast<Index>(t));
  }
  std::sort(keys.begin(), keys.end());
  std::size_t count = 0, first = mesh.triangles.size(), original = 0;
  for (std::size_t i = 1; i < keys.size(); ++i) {
    if (keys[i].first != keys[i - 1].first) continue;
    skipped[keys[i].second] = 1;
    ++count;
    if (keys[i].second >= first) continue;
    first = keys[i].second;
    original = keys[i - 1].second;
  }
  if (count == 0) return;
  problems.push_back({ErrorCode::duplicate_triangle,
                      number(count) + (count == 1 ? " triangle is" : " triangles are") +
                          " in the mesh already; the first is triangle " + number(first) +
                          ", the same as triangle " + number(original),
                      count, first});
}

void find_non_manifold_edges(const std::vector<EdgeSides>& edges, std::vector<Problem>& problems) {
  std::size_t count = 0;
  const EdgeSides* first = nullptr;
  for (const EdgeSides& edge : edges) {
    if (edge.size() <= 2) continue;
    ++count;
    if (first == nullptr) first = &edge;
  }
  if (count == 0) return;
  problems.push_back({ErrorCode::non_manifold_edge,
                      number(count) + (count == 1 ? " edge is" : " edges are") +
                          " shared by more than two triangles; the first joins vertices " +
                          number(first->begin->low) + " and " + number(first->begin->high) +
                          " and has " + number(first->size()),
                      count, first->begin->low});
}

void find_clashing_orientation(const TriMesh& mesh, const std::vector<EdgeSides>& edges,
                               const std::vector<unsigned char>& skipped,
                               std::vector<Problem>& problems) {
  TurningSets orientation(mesh.triangles.size());
  const EdgeSide* twist = nullptr;
  std::size_t clashes = 0;
  for (const EdgeSides& edge : edges) {
    if (edge.size() != 2) continue;
    const unsigned char clash = edge.begin[0].forward == edge.begin[1].forward ? 1 : 0;
    clashes += clash;
    if (!orientation.join(edge.begin[0].triangle, edge.begin[1].triangle, clash) &&
        twist == nullptr) {
      twist = edge.begin;
    }
  }
  if (twist != nullptr) {
    problems.push_back({ErrorCode::non_orientable,
                        "the surface has one side only (like a Moebius strip): no choice of "
                        "orientation fits the edge of vertices " +
                            number(twist->low) + " and " + number(twist->high),
                        1, twist->low});
    return;
  }
  if (clashes == 0) return;
  // In each group the minority is what was turned over by mistake.
  std::vector<std::size_t> members(mesh.triangles.size(), 0), turned(mesh.triangles.size(), 0);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (skipped[t] != 0) continue;
    const auto root = orientation.first_of(static_cast<Index>(t));
    ++members[root.number];
    turned[root.number] += root.turned;
  }
  std::size_t count = 0, first = 0;
  for (std::size_t t = mesh.triangles.size(); t-- > 0;) {
    if (skipped[t] != 0) continue;
    const auto root = orientation.first_of(static_cast<Index>(t));
    const bool few_turned = 2 * turned[root.number] <= members[root.number];
    if ((root.turned != 0) != few_turned) continue;
    ++count;
    first = t;
  }
  problems.push_back(
      {ErrorCode::inconsistent_orientation,
       number(count) +
           (count == 1 ? " triangle is oriented against its"
                       : " triangles are oriented against their") +
           " neighbours; the first is triangle " + number(first) +
           ": make the orientation consistent (mesh programs call it recalculate or unify normals)",
       count, first});
}

/// Vertices at which the triangles are more than one fan.
void find_non_manifold_vertices(const TriMesh& mesh, const std::vector<EdgeSides>& edges,
                                const std::vector<unsigned char>& skipped,
                                std::vector<Problem>& problems) {
  // Corners joined across the edges at their vertex; a manifold vertex keeps one group.
  std::vector<Index> parent(3 * mesh.triangles.size());
  std::iota(parent.begin(), parent.end(), Index{0});
  const auto root = [&parent](Index c) {
    while (parent[c] != c)
      c = parent[c] = parent[parent[c]];
    return c;
  };
  const auto corner = [&mesh](Index triangle, Index v) {
    const Triangle& tri = mesh.triangles[triangle];
    return 3 * triangle + (tri[0] == v ? 0 : tri[1] == v ? 1 : 2);
  };
  for (const EdgeSides& edge : edges) {
    for (const EdgeSide* side = edge.begin + 1; side < edge.end; ++side) {
      for (const Index v : {edge.begin->low, edge.begin->high}) {
        parent[root(corner(side->triangle, v))] = root(corner(edge.begin->triangle, v));
      }
    }
  }
  std::vector<Index> fans(mesh.positions.size(), 0);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (skipped[t] != 0) continue;
    for (Index k = 0; k < 3; ++k) {
      const Index c = static_cast<Index>(3 * t) + k;
      if (parent[c] == c) ++fans[mesh.triangles[t][k]];
    }
  }
  const auto several = [](Index n) { return n > 1; };
  const auto count = static_cast<std::size_t>(std::count_if(fans.begin(), fans.end(), several));
  if (count == 0) return;
  const auto first =
      static_cast<std::size_t>(std::find_if(fans.begin(), fans.end(), several) - fans.begin());
  problems.push_back({ErrorCode::non_manifold_vertex,
                      number(count) + (count == 1 ? " vertex joins" : " vertices join") +
                          " parts of the surface that share no edge there; the first is vertex " +
                          number(first),
                      count, first});
}

}  // namespace

ManifoldDefects find_manifold_defects(const TriMesh& mesh) {
  ManifoldDefects defects;
  std::vector<unsigned char> skipped(mesh.triangles.size(), 0);
  find_repeated_indices(mesh, skipped, defects.problems);
  find_duplicates(mesh, skipped, defects.problems);
  const std::vector<EdgeSide> sides = sorted_sides(mesh, skipped);
  const std::vector<EdgeSides> edges = group_by_edge(sides);
  find_non_manifold_edges(edges, defects.problems);
  find_clashing_orientation(mesh, edges, skipped, defects.problems);
  find_non_manifold_vertices(mesh, edges, skipped, defects.problems);
  defects.edges = edges.size();
  std::vector<unsigned char> used(mesh.positions.size(), 0);
  for (const Triangle& t : mesh.triangles) {
    for (const Index v : t)
      used[v] = 1;
  }
  defects.used_vertices = static_cast<std::size_t>(std::count(used.begin(), used.end(), 1));
  return defects;
}

}  // namespace planish
