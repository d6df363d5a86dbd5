#pragma once

// Meshes as other programs leave them, and what every repair keeps.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <set>
#include <utility>
#include <vector>

#include <planish/mesh/inspect.h>
#include <planish/mesh/patch.h>
#include <planish/mesh/repair.h>
#include <planish/mesh/tri_mesh.h>

#include "support/meshes.h"

namespace planish::repairs {

using meshes::area;

/// A quarter of a cylinder, radius and length as told, its normals away from the axis.
inline TriMesh shell(std::size_t around, std::size_t along, double radius = 100.0,
                     double length = 150.0) {
  TriMesh mesh = meshes::flat_grid(around, along);
  for (Vec3& p : mesh.positions) {
    const double angle = 0.5 * std::numbers::pi * p.x / static_cast<double>(around);
    p = {-radius * std::cos(angle), length * p.y / static_cast<double>(along),
         radius * std::sin(angle)};
  }
  return mesh;
}

/// Both meshes, the second one's vertices behind those of the first.
inline TriMesh both(TriMesh first, const TriMesh& second) {
  const auto shift = static_cast<Index>(first.positions.size());
  first.positions.insert(first.positions.end(), second.positions.begin(), second.positions.end());
  for (const Triangle& t : second.triangles)
    first.triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
  return first;
}

/// Both sides of a sheet of a grid, the second one reversed.
inline TriMesh sheets(const TriMesh& outer, const TriMesh& inner) {
  return both(outer, turned_over(inner));
}

/// The same with a rim around.
inline TriMesh closed(const TriMesh& outer, const TriMesh& inner) {
  TriMesh mesh = sheets(outer, inner);
  const auto shift = static_cast<Index>(outer.positions.size());
  const Patch patch(outer);
  for (const auto& loop : patch.border_loops()) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Index a = loop[i], b = loop[(i + 1) % loop.size()];
      mesh.triangles.push_back({b, a, a + shift});
      mesh.triangles.push_back({b, a + shift, b + shift});
    }
  }
  return mesh;
}

inline TriMesh mirrored(TriMesh mesh) {
  for (Vec3& p : mesh.positions)
    p.x = -p.x;
  return turned_over(std::move(mesh));
}

/// Three grids of 4 x 5 whose first columns lie on one line: the second is the mirror image of the
/// first, the third stands upright.
inline std::array<TriMesh, 3> three_on_one_line() {
  const TriMesh one = meshes::flat_grid(4, 5);
  TriMesh third = one;
  for (Vec3& p : third.positions)
    p = {0.0, p.y, p.x};
  return {one, mirrored(one), third};
}

/// The triangles in the opposite order, each beginning with its last corner.
inline TriMesh reordered(TriMesh mesh) {
  std::reverse(mesh.triangles.begin(), mesh.triangles.end());
  for (Triangle& t : mesh.triangles)
    t = {t[2], t[0], t[1]};
  return mesh;
}

/// The mesh as it is, mirrored, in another order, and a thousand times as small and as large.
inline std::vector<TriMesh> variants(const TriMesh& mesh) {
  return {mesh, mirrored(mesh), reordered(mesh), scaled(mesh, 1e-3), scaled(mesh, 1e3)};
}

/// Whether vertices keep their numbers and places, and every triangle and new vertex tells where it
/// comes from.
inline bool has_sources(const RepairedMesh& repaired, const TriMesh& mesh) {
  const std::size_t count = mesh.positions.size();
  bool right = repaired.source.size() == repaired.mesh.triangles.size() &&
               repaired.vertex_source.size() == repaired.mesh.positions.size() &&
               repaired.mesh.positions.size() >= count;
  for (std::size_t v = 0; right && v < repaired.mesh.positions.size(); ++v) {
    const Index source = repaired.vertex_source[v];
    right = source < count && (v >= count || source == v) &&
            repaired.mesh.positions[v] == mesh.positions[source];
  }
  for (const Index t : repaired.source)
    right = right && (t == RepairedMesh::none || t < mesh.triangles.size());
  return right;
}

inline bool is_disk(const TriMesh& mesh) {
  const Inspection found = inspect(mesh);
  return !blocking_problem(found, Purpose::unfold) && found.topology.components == 1;
}

}  // namespace planish::repairs
