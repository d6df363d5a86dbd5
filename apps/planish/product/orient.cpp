#include "product/orient.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <planish/mesh/patch.h>
#include <planish/mesh/repair.h>
#include <planish/mesh/seams.h>

#include "shell/values.h"

namespace planish::cli {

namespace {

/// An edge of a side of a seam.
struct SideEdge {
  double middle = 0.0;  ///< as a fraction of the length of the side
  double length = 0.0;  ///< as a fraction of that
  Vec3 inside;          ///< into the patch, at right angles to the edge; length 1
};

/// A mesh that can have seams.
struct Piece {
  std::size_t patch;  ///< its number in the product
  Connectivity connectivity;
};

/// The third corner of the triangle at an edge of the border; nothing where the edge is none.
std::optional<Index> third_corner(const Connectivity& connectivity, Index a, Index b) {
  for (const auto& [from, to] : {std::pair(a, b), std::pair(b, a)}) {
    // The ring of a border vertex begins with the next one along the border.
    const auto ring = connectivity.ring(from);
    if (connectivity.is_border(from) && ring.size() > 1 && ring[0] == to) return ring[1];
  }
  return std::nullopt;
}

std::vector<SideEdge> edges_of(const SeamSide& side, const TriMesh& mesh,
                               const Connectivity& connectivity) {
  std::vector<SideEdge> edges;
  double whole = 0.0;
  for (std::size_t k = 1; k < side.vertices.size(); ++k) {
    const Index from = side.vertices[k - 1], to = side.vertices[k];
    const Vec3 edge = mesh.positions[to] - mesh.positions[from];
    const double length = norm(edge);
    const auto third = third_corner(connectivity, from, to);
    whole += length;
    if (!third || !(length > 0.0)) continue;
    const Vec3 way = mesh.positions[*third] - mesh.positions[from];
    const Vec3 across = way - dot(way, edge) / dot(edge, edge) * edge;
    if (norm(across) > 0.0)
      edges.push_back({whole - 0.5 * length, length, 1.0 / norm(across) * across});
  }
  for (SideEdge& edge : edges)
    edge = {edge.middle / whole, edge.length / whole, edge.inside};
  return edges;
}

/// Whether both patches lie on one side of the seam, one on the other: along all of it, as a facing
/// does on its panel, and not at the corners of a cushion alone.
bool is_between_layers(const Seam& seam, const std::vector<TriMesh>& meshes,
                       const std::vector<Piece>& pieces) {
  constexpr double k_same_way = 0.9;  // mean cosine
  const auto edges_of_side = [&](const SeamSide& side) {
    return edges_of(side, meshes[side.patch], pieces[side.patch].connectivity);
  };
  const std::vector<SideEdge> one = edges_of_side(seam.sides[0]);
  const std::vector<SideEdge> other = edges_of_side(seam.sides[1]);
  if (one.empty() || other.empty()) return false;
  double cosine = 0.0, length = 0.0;
  for (const SideEdge& edge : one) {
    const double place = matched_share(seam, edge.middle);
    auto beside = std::lower_bound(
        other.begin(), other.end(), place,
        [](const SideEdge& e, double at) { return e.middle + 0.5 * e.length < at; });
    if (beside == other.end()) --beside;
    cosine += edge.length * dot(edge.inside, beside->inside);
    length += edge.length;
  }
  return cosine > k_same_way * length;
}

}  // namespace

void turn_inside_out(std::vector<ProductPatch>& patches, double tolerance, Session& session) {
  std::vector<TriMesh> meshes;
  std::vector<std::size_t> groups;
  std::vector<Piece> pieces;
  for (std::size_t p = 0; p < patches.size(); ++p) {
    auto connectivity = Connectivity::build(patches[p].mesh);
    if (!connectivity) continue;
    meshes.push_back(patches[p].mesh);
    groups.push_back(patches[p].group);
    pieces.push_back({p, *std::move(connectivity)});
  }
  std::vector<Seam> seams = find_seams_in_groups(meshes, groups, tolerance);
  const std::vector<std::size_t> by_all = find_inside_out(meshes, seams);
  std::erase_if(seams, [&](const Seam& seam) { return is_between_layers(seam, meshes, pieces); });
  const std::vector<std::size_t> by_sure = find_inside_out(meshes, seams);
  std::vector<std::string> turned, unsure;
  for (const std::size_t p : by_sure) {
    ProductPatch& patch = patches[pieces[p].patch];
    patch.mesh = turned_over(std::move(patch.mesh));
    turned.push_back(patch.name);
  }
  for (const std::size_t p : by_all) {
    if (!std::binary_search(by_sure.begin(), by_sure.end(), p))
      unsure.push_back(patches[pieces[p].patch].name);
  }
  if (!turned.empty()) {
    session.note("turned over, as they were inside out against a neighbour along a seam: " +
                 list_of_some(turned));
  }
  if (!unsure.empty()) {
    session.note("these lie flat on a neighbour, so it is not known whether they are inside out: " +
                 list_of_some(unsure) + "; --flip turns a piece over");
  }
}

}  // namespace planish::cli
