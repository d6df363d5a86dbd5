#include "mesh/match/twins.h"

#include <cmath>
#include <map>
#include <utility>

#include "core/job.h"
#include "mesh/match/mesh_walk.h"
#include "mesh/match/rigid_fit.h"

namespace planish {

namespace {

// Steps of all tries, over the number of vertices. A walk through a mesh takes seven a vertex.
constexpr std::size_t k_tries = 500;

/// A mesh that others may be twins of.
struct Kind {
  std::size_t number;
  double tolerance;  // of lengths, at the scale of the mesh
  WalkedMesh mesh;
};

/// A mesh that is turned may have half or twice the scale.
bool may_match(const Kind& kind, const WalkedMesh& mesh) {
  const double factor = kind.mesh.scale / mesh.scale;
  const std::size_t n = kind.mesh.border().size();
  return n == mesh.border().size() && factor >= 0.5 && factor <= 2.0 &&
         std::abs(kind.mesh.perimeter - factor * mesh.perimeter) <=
             kind.tolerance * static_cast<double>(n);
}

/// The motion in the units of the meshes, which were scaled.
RigidMotion unscaled(RigidMotion motion, double scale) {
  motion.shift = 1.0 / scale * motion.shift;
  return motion;
}

std::optional<MeshMatch> match_as(const Kind& kind, const WalkedMesh& mesh, bool mirrored,
                                  WalkBudget& budget) {
  const std::vector<Vec3>&from = kind.mesh.positions, &to = mesh.positions;
  for (std::size_t start = 0; start < mesh.border().size(); ++start) {
    auto pair = walk_both(kind.mesh, mesh, mirrored, start, kind.tolerance, budget);
    if (!pair) continue;
    const RigidMotion motion = rigid_fit(from, to, *pair, mirrored, kind.tolerance);
    if (!brings_together(motion, from, to, *pair, kind.tolerance)) continue;
    return MeshMatch{mirrored, *std::move(pair), unscaled(motion, mesh.scale)};
  }
  return std::nullopt;
}

std::optional<MeshMatch> match(const Kind& kind, const WalkedMesh& mesh) {
  if (!may_match(kind, mesh)) return std::nullopt;
  if (mesh.scale != kind.mesh.scale) return match(kind, rescaled(mesh, kind.mesh.scale));
  WalkBudget budget{k_tries * mesh.positions.size()};
  auto found = match_as(kind, mesh, false, budget);
  return found ? std::move(found) : match_as(kind, mesh, true, budget);
}

std::optional<MeshTwin> twin_of(const std::vector<Kind>& kinds, const WalkedMesh& mesh) {
  for (const Kind& kind : kinds) {
    if (auto found = match(kind, mesh)) return MeshTwin{kind.number, *std::move(found)};
  }
  return std::nullopt;
}

}  // namespace

std::vector<std::optional<MeshTwin>> find_twins(std::span<const TriMesh* const> meshes,
                                                double tolerance, const Context& context) {
  std::vector<std::optional<MeshTwin>> twins(meshes.size());
  std::map<std::pair<std::size_t, std::size_t>, std::vector<std::size_t>> of_size;
  for (std::size_t m = 0; m < meshes.size(); ++m)
    of_size[{meshes[m]->positions.size(), meshes[m]->triangles.size()}].push_back(m);
  for (const auto& [size, numbers] : of_size) {
    if (numbers.size() < 2 || size.second == 0) continue;
    std::vector<Kind> kinds;
    for (const std::size_t m : numbers) {
      stop_if_cancelled(context);
      auto mesh = walked_mesh(*meshes[m]);
      if (!mesh) continue;
      twins[m] = twin_of(kinds, *mesh);
      if (twins[m]) continue;
      const double diagonal = mesh->scale * bounding_box_diagonal(*meshes[m]);
      kinds.push_back({m, tolerance * diagonal, *std::move(mesh)});
    }
  }
  return twins;
}

}  // namespace planish
