#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include <planish/mesh/seams.h>

#include "mesh/match/borders.h"
#include "mesh/search/box_tree.h"

namespace planish {

namespace {

constexpr double k_reach = 0.1;     // distance over the length of the edge
constexpr double k_parallel = 0.9;  // cosine between the edges
constexpr std::size_t k_steps = 6;  // along a loop, within which edges are neighbours
constexpr std::size_t k_fewest_beside = 8;

/// The distance of a place from a segment.
double distance_to(Vec3 p, Vec3 a, Vec3 b) {
  const Vec3 along = b - a;
  const double square = dot(along, along);
  const double share = square > 0.0 ? std::clamp(dot(p - a, along) / square, 0.0, 1.0) : 0.0;
  return norm(p - (a + share * along));
}

bool is_within(const Box& box, Vec3 p, double distance) {
  return p.x >= box.low.x - distance && p.x <= box.high.x + distance &&
         p.y >= box.low.y - distance && p.y <= box.high.y + distance &&
         p.z >= box.low.z - distance && p.z <= box.high.z + distance;
}

class NearEdges {
 public:
  explicit NearEdges(std::span<const TriMesh> patches)
      : patches_(patches), edges_(border_edges(patches)), tree_(segments()) {}

  const std::vector<BorderEdge>& edges() const { return edges_; }

  Vec3 place(std::size_t patch, Index v) const { return patches_[patch].positions[v]; }
  Vec3 along(std::size_t e) const {
    return place(edges_[e].patch, edges_[e].to) - place(edges_[e].patch, edges_[e].from);
  }

  /// The patches whose borders lie beside the middle of the edge.
  std::set<std::size_t> patches_beside(std::size_t e) const {
    const BorderEdge& edge = edges_[e];
    const double length = norm(along(e)), reach = k_reach * length;
    const Vec3 middle = place(edge.patch, edge.from) + 0.5 * along(e);
    std::set<std::size_t> beside;
    std::vector<std::size_t> open = {0};
    while (!open.empty()) {
      const std::size_t number = open.back();
      open.pop_back();
      const BoxTree::Node& node = tree_.nodes()[number];
      if (!is_within(node.box, middle, reach)) continue;
      if (!node.is_leaf()) {
        open.insert(open.end(), {number + 1, node.second});
        continue;
      }
      for (std::size_t place = node.begin; place < node.end; ++place) {
        const std::size_t other = tree_.triangle(place);
        const BoxTree::Corners corners = tree_.corners(place);
        const bool is_near = distance_to(middle, corners[0], corners[1]) <= reach &&
                             is_parallel(e, other) && !are_neighbours(e, other);
        if (is_near) beside.insert(edges_[other].patch);
      }
    }
    return beside;
  }

 private:
  /// Every edge as a triangle without area.
  TriMesh segments() const {
    TriMesh mesh;
    for (const BorderEdge& edge : edges_) {
      const auto first = static_cast<Index>(mesh.positions.size());
      mesh.positions.push_back(place(edge.patch, edge.from));
      mesh.positions.push_back(place(edge.patch, edge.to));
      mesh.triangles.push_back({first, first + 1, first + 1});
    }
    return mesh;
  }

  bool is_parallel(std::size_t e, std::size_t other) const {
    const Vec3 a = along(e), b = along(other);
    return std::abs(dot(a, b)) >= k_parallel * norm(a) * norm(b);
  }

  bool are_neighbours(std::size_t e, std::size_t other) const {
    std::size_t ahead = e, behind = e;
    for (std::size_t step = 0; step <= k_steps; ++step) {
      if (ahead == other || behind == other) return true;
      ahead = edges_[ahead].next;
      behind = edges_[behind].previous;
    }
    return false;
  }

  std::span<const TriMesh> patches_;
  std::vector<BorderEdge> edges_;
  BoxTree tree_;
};

using PlacedEdge = std::tuple<std::size_t, Index, Index>;  // patch, and vertices in any order

PlacedEdge placed(std::size_t patch, Index a, Index b) {
  return {patch, std::min(a, b), std::max(a, b)};
}

std::set<PlacedEdge> edges_of(std::span<const Seam> seams) {
  std::set<PlacedEdge> edges;
  for (const Seam& seam : seams) {
    for (const SeamSide& side : seam.sides) {
      for (std::size_t k = 1; k < side.vertices.size(); ++k)
        edges.insert(placed(side.patch, side.vertices[k - 1], side.vertices[k]));
    }
  }
  return edges;
}

}  // namespace

std::vector<NearBorders> find_near_borders(std::span<const TriMesh> patches,
                                           std::span<const Seam> seams) {
  const NearEdges borders(patches);
  if (borders.edges().empty()) return {};
  const std::set<PlacedEdge> sewn = edges_of(seams);
  struct Found {
    std::size_t edges = 0;
    double length = 0.0;
  };
  std::map<std::pair<std::size_t, std::size_t>, Found> found;  // from the first to the second
  for (std::size_t e = 0; e < borders.edges().size(); ++e) {
    const BorderEdge& edge = borders.edges()[e];
    if (sewn.count(placed(edge.patch, edge.from, edge.to)) > 0) continue;
    for (const std::size_t other : borders.patches_beside(e)) {
      Found& here = found[{edge.patch, other}];
      ++here.edges;
      here.length += norm(borders.along(e)) * (edge.patch == other ? 0.5 : 1.0);
    }
  }
  std::vector<NearBorders> near;
  for (const auto& [pair, here] : found) {
    const auto [first, second] = pair;
    const auto back = found.find({second, first});
    const bool is_mutual = back != found.end() && back->second.edges >= k_fewest_beside;
    if (first > second || here.edges < k_fewest_beside || !is_mutual) continue;
    near.push_back({{first, second}, std::min(here.length, back->second.length)});
  }
  return near;
}

}  // namespace planish
