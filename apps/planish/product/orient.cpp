#include "product/orient.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include <planish/mesh/patch.h>
#include <planish/mesh/repair.h>
#include <planish/mesh/seams.h>

namespace planish::cli {

namespace {

/// From the middle edge of the side into the patch, at right angles to the edge; length 1. Nothing
/// where no triangle has that edge.
std::optional<Vec3> way_inside(const SeamSide& side, const TriMesh& mesh) {
  const std::size_t middle = side.vertices.size() / 2;
  const Index a = side.vertices[middle - 1], b = side.vertices[middle];
  for (const Triangle& t : mesh.triangles) {
    const auto has = [&](Index v) { return std::find(t.begin(), t.end(), v) != t.end(); };
    if (!has(a) || !has(b)) continue;
    const Index third =
        *std::find_if(t.begin(), t.end(), [&](Index v) { return v != a && v != b; });
    const Vec3 edge = mesh.positions[b] - mesh.positions[a];
    const Vec3 inside = mesh.positions[third] - mesh.positions[a];
    const Vec3 across = inside - dot(inside, edge) / dot(edge, edge) * edge;
    return 1.0 / norm(across) * across;
  }
  return std::nullopt;
}

/// Whether both patches lie on one side of the seam, one on the other.
bool is_between_layers(const Seam& seam, const std::vector<TriMesh>& meshes) {
  constexpr double k_same_way = 0.9;  // cosine
  const auto one = way_inside(seam.sides[0], meshes[seam.sides[0].patch]);
  const auto other = way_inside(seam.sides[1], meshes[seam.sides[1].patch]);
  return one && other && dot(*one, *other) > k_same_way;
}

}  // namespace

void turn_inside_out(std::vector<ProductPatch>& patches, double tolerance, Session& session) {
  std::vector<TriMesh> meshes;
  std::vector<std::size_t> groups, numbers;  // of the patches that can have seams
  for (std::size_t p = 0; p < patches.size(); ++p) {
    if (!Connectivity::build(patches[p].mesh)) continue;
    meshes.push_back(patches[p].mesh);
    groups.push_back(patches[p].group);
    numbers.push_back(p);
  }
  std::vector<Seam> seams = find_seams_in_groups(meshes, groups, tolerance);
  std::erase_if(seams, [&](const Seam& seam) { return is_between_layers(seam, meshes); });
  std::string names;
  for (const std::size_t turned : find_inside_out(meshes, seams)) {
    ProductPatch& patch = patches[numbers[turned]];
    patch.mesh = turned_over(std::move(patch.mesh));
    names += (names.empty() ? "" : ", ") + patch.name;
  }
  if (!names.empty())
    session.note("turned over, inside out against a neighbour along a seam: " + names);
}

}  // namespace planish::cli
