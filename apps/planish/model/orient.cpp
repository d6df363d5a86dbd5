#include "model/orient.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <planish/flatten/product.h>
#include <planish/mesh/patch.h>
#include <planish/mesh/repair.h>
#include <planish/mesh/seams.h>

#include "shell/command_line.h"
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
struct SewnPiece {
  std::size_t number;  ///< among all pieces
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
                       const std::vector<SewnPiece>& pieces) {
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

/// Of a piece that is inside out the neighbour, which is not, with the longest seam to it.
/// @param inside_out increasing
std::optional<std::size_t> fitting_neighbour(std::size_t piece, const std::vector<Seam>& seams,
                                             const std::vector<TriMesh>& meshes,
                                             const std::vector<std::size_t>& inside_out) {
  std::optional<std::size_t> neighbour;
  double longest = 0.0;
  for (const Seam& seam : seams) {
    for (const std::size_t side : {0, 1}) {
      const std::size_t other = seam.sides[1 - side].patch;
      if (seam.sides[side].patch != piece || other == piece ||
          std::binary_search(inside_out.begin(), inside_out.end(), other))
        continue;
      const double length = length_of(seam.sides[side], meshes[piece].positions);
      if (!(length > longest)) continue;
      longest = length;
      neighbour = other;
    }
  }
  return neighbour;
}

/// "B against A"
std::string pair_text(const std::string& name, const std::string* neighbour) {
  return neighbour == nullptr ? name : name + " against " + *neighbour;
}

}  // namespace

InsideOut pieces_inside_out(std::span<const PlacedPiece> pieces, double tolerance, bool strict) {
  std::vector<TriMesh> meshes;
  std::vector<std::size_t> groups;
  std::vector<SewnPiece> sewn;
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    auto connectivity = Connectivity::build(pieces[p].mesh);
    if (!connectivity) continue;
    meshes.push_back(pieces[p].mesh);
    groups.push_back(pieces[p].group);
    sewn.push_back({p, *std::move(connectivity)});
  }
  std::vector<Seam> seams = find_seams_in_groups(meshes, groups, tolerance);
  const std::vector<std::size_t> by_all = find_inside_out(meshes, seams);
  std::erase_if(seams, [&](const Seam& seam) { return is_between_layers(seam, meshes, sewn); });
  const std::vector<std::size_t> by_sure = find_inside_out(meshes, seams);
  InsideOut result;
  std::vector<std::string> names, pairs, unsure;
  for (const std::size_t k : by_sure) {
    const PlacedPiece& piece = pieces[sewn[k].number];
    if (!piece.is_taken) continue;
    const auto neighbour = fitting_neighbour(k, seams, meshes, by_sure);
    names.push_back(piece.name);
    pairs.push_back(
        pair_text(piece.name, neighbour ? &pieces[sewn[*neighbour].number].name : nullptr));
    if (!strict) result.turned.push_back(sewn[k].number);
  }
  for (const std::size_t k : by_all) {
    const PlacedPiece& piece = pieces[sewn[k].number];
    if (piece.is_taken && !std::binary_search(by_sure.begin(), by_sure.end(), k))
      unsure.push_back(piece.name);
  }
  if (!pairs.empty() && strict) {
    result.notes.push_back("inside out along a seam: " + list_of_some(pairs) +
                           "; --strict leaves that so, and the pattern is the mirror image: leave "
                           "out --strict, or turn a piece over with --only " +
                           shell_word(names.front()) + " --flip");
  } else if (!pairs.empty()) {
    result.notes.push_back(
        "turned over, as they were inside out against a neighbour along a seam: " +
        list_of_some(pairs));
  }
  if (!unsure.empty()) {
    result.notes.push_back(
        "these lie flat on a neighbour, so it is not known whether they are inside out: " +
        list_of_some(unsure) + "; --flip turns a piece over");
  }
  return result;
}

std::vector<std::string> turn_inside_out(Model& model, const ModelOptions& options) {
  const bool is_as_asked = options.strict && options.flip;
  if (model.pieces.size() != 1 || model.left_out.empty() || is_as_asked) return {};
  std::vector<PlacedPiece> pieces;
  pieces.reserve(model.left_out.size() + 1);
  for (const LeftOutPiece& other : model.left_out) {
    if (other.before == 0) pieces.push_back({other.name, other.mesh, 0, false});
  }
  const std::size_t own = pieces.size();
  pieces.push_back({model.pieces.front(), model.mesh});
  for (const LeftOutPiece& other : model.left_out) {
    if (other.before > 0) pieces.push_back({other.name, other.mesh, 0, false});
  }
  InsideOut found = pieces_inside_out(pieces, 0.0, options.strict);
  model.turned = found.turned == std::vector{own};
  if (model.turned) model.mesh = turned_over(std::move(model.mesh));
  return std::move(found.notes);
}

}  // namespace planish::cli
