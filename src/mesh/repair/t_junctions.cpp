#include "mesh/repair/t_junctions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <span>
#include <tuple>

#include "mesh/search/box_tree.h"

namespace planish {

namespace {

// A triangle is higher than this multiple of the distance of the vertex from its edge.
constexpr double k_least_height = 3.0;
// Of the largest coordinate: what rounding moves a vertex off its edge.
constexpr double k_off_by_rounding = 0x1p-50;

/// Calls visit(place) for the triangles of the tree whose boxes are within the reach of p.
template <class Visit>
void for_each_within(const BoxTree& tree, Vec3 p, double reach, const Visit& visit) {
  const std::span<const BoxTree::Node> nodes = tree.nodes();
  const auto is_far = [reach](double low, double high, double at) {
    return at < low - reach || at > high + reach;
  };
  std::array<std::size_t, 64> waiting{};  // deeper than any tree
  std::size_t count = 1;
  while (count > 0) {
    const std::size_t number = waiting[--count];
    const BoxTree::Node& node = nodes[number];
    if (is_far(node.box.low.x, node.box.high.x, p.x) ||
        is_far(node.box.low.y, node.box.high.y, p.y) ||
        is_far(node.box.low.z, node.box.high.z, p.z)) {
      continue;
    }
    if (!node.is_leaf()) {
      waiting[count++] = node.second;
      waiting[count++] = number + 1;
      continue;
    }
    for (std::size_t place = node.begin; place < node.end; ++place)
      visit(tree.triangle(place));
  }
}

/// The border edges as triangles of two corners.
TriMesh edges_as_triangles(const TriMesh& mesh, const std::vector<EdgeSide>& border) {
  TriMesh edges{mesh.positions, {}};
  for (const EdgeSide& side : border)
    edges.triangles.push_back({side.low, side.high, side.high});
  return edges;
}

double largest_coordinate(const TriMesh& mesh) {
  double largest = 0.0;
  for (const Triangle& t : mesh.triangles) {
    for (const Index v : t) {
      const Vec3& p = mesh.positions[v];
      largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    }
  }
  return largest;
}

/// The share of the side's edge that is beside p, if that lies on the edge.
std::optional<double> share_beside(const TriMesh& mesh, const EdgeSide& side, Vec3 p,
                                   double reach) {
  const Triangle& corners = mesh.triangles[side.triangle];
  const Vec3 from = mesh.positions[corners[side.corner]];
  const Vec3 edge = mesh.positions[corners[(side.corner + 1) % 3]] - from;
  const Vec3 apex = mesh.positions[corners[(side.corner + 2) % 3]] - from;
  const double squared = dot(edge, edge);
  if (!(squared > 0.0)) return std::nullopt;
  const double length = std::sqrt(squared), share = dot(p - from, edge) / squared;
  const double off = norm(p - from - share * edge);
  if (!(off <= reach) || !(share * length > reach) || !((1.0 - share) * length > reach))
    return std::nullopt;
  const double height = norm(cross(edge, apex)) / length;
  if (!(height > k_least_height * off) || !(height > 0.0)) return std::nullopt;
  return share;
}

/// Divides a triangle at the vertices on its sides; each part is put behind the others.
void divide(const Triangle& corners, const std::array<std::vector<Index>, 3>& on_side,
            std::vector<Triangle>& parts) {
  parts.push_back(corners);
  std::array<std::size_t, 3> owner{};  // of each side: the part that has it
  std::array<std::size_t, 3> corner{0, 1, 2};
  for (std::size_t k = 0; k < 3; ++k) {
    std::size_t part = owner[k];
    // The part's corners from the side's first one on.
    const auto at = [&](std::size_t i) { return parts[part][(corner[k] + i) % 3]; };
    for (const Index v : on_side[k]) {
      const Triangle rest{v, at(1), at(2)};
      parts[part][(corner[k] + 1) % 3] = v;
      // The next side goes with the rest, that after it stays.
      const std::size_t next = (k + 1) % 3;
      if (owner[next] == part && k < 2) {
        owner[next] = parts.size();
        corner[next] = 1;
      }
      part = parts.size();
      corner[k] = 0;
      parts.push_back(rest);
    }
  }
}

}  // namespace

std::vector<TJunction> find_t_junctions(const TriMesh& mesh, const std::vector<EdgeSide>& border,
                                        const BorderPlaces& places) {
  std::vector<TJunction> junctions;
  if (border.empty()) return junctions;
  const BoxTree tree(edges_as_triangles(mesh, border));
  const double rounding = k_off_by_rounding * largest_coordinate(mesh);
  std::vector<Index> vertices;
  for (const EdgeSide& side : border) {
    for (const Index v : {side.low, side.high})
      vertices.push_back(places.of_vertex[v]);
  }
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  for (const Index v : vertices) {
    const double reach = std::max(places.reach[v], rounding);
    for_each_within(tree, mesh.positions[v], reach, [&](Index number) {
      const EdgeSide& side = border[number];
      for (const Index corner : mesh.triangles[side.triangle]) {
        if (places.of_vertex[corner] == v) return;
      }
      if (const auto share = share_beside(mesh, side, mesh.positions[v], reach))
        junctions.push_back({side, *share, v});
    });
  }
  const auto key = [](const TJunction& junction) {
    return std::tie(junction.side.triangle, junction.side.corner, junction.share);
  };
  std::sort(junctions.begin(), junctions.end(), [&](const TJunction& a, const TJunction& b) {
    return key(a) != key(b) ? key(a) < key(b) : a.vertex < b.vertex;
  });
  junctions.erase(
      std::unique(junctions.begin(), junctions.end(),
                  [&](const TJunction& a, const TJunction& b) { return key(a) == key(b); }),
      junctions.end());
  return junctions;
}

DividedTriangles divide_at(const TriMesh& mesh, const std::vector<TJunction>& junctions) {
  DividedTriangles result{mesh, std::vector<Index>(mesh.triangles.size()),
                          std::vector<Index>(mesh.positions.size())};
  std::iota(result.source.begin(), result.source.end(), Index{0});
  std::iota(result.vertex_source.begin(), result.vertex_source.end(), Index{0});
  for (auto at = junctions.begin(); at != junctions.end();) {
    const Index triangle = at->side.triangle;
    std::array<std::vector<Index>, 3> on_side;
    for (; at != junctions.end() && at->side.triangle == triangle; ++at) {
      on_side[at->side.corner].push_back(static_cast<Index>(result.mesh.positions.size()));
      result.mesh.positions.push_back(mesh.positions[at->vertex]);
      result.vertex_source.push_back(at->vertex);
    }
    std::vector<Triangle> parts;
    divide(mesh.triangles[triangle], on_side, parts);
    result.mesh.triangles[triangle] = parts.front();
    result.mesh.triangles.insert(result.mesh.triangles.end(), parts.begin() + 1, parts.end());
    result.source.insert(result.source.end(), parts.size() - 1, triangle);
  }
  return result;
}

}  // namespace planish
