#include "panels/cells/halved_product.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include <planish/mesh/imprint.h>
#include <planish/mesh/inspect.h>
#include <planish/mesh/symmetry.h>

#include "mesh/match/symmetric_whole.h"
#include "panels/piece/panel_mesh.h"

namespace planish {

namespace {

/// Puts a vertex in the middle of the edge between two.
void divide_edge(TriMesh& mesh, Index v, Index w) {
  const auto middle = static_cast<Index>(mesh.positions.size());
  mesh.positions.push_back(0.5 * (mesh.positions[v] + mesh.positions[w]));
  const std::size_t count = mesh.triangles.size();
  for (std::size_t t = 0; t < count; ++t) {
    Triangle second = mesh.triangles[t];
    const auto first_end = std::find(second.begin(), second.end(), v);
    const auto second_end = std::find(second.begin(), second.end(), w);
    if (first_end == second.end() || second_end == second.end()) continue;
    mesh.triangles[t][static_cast<std::size_t>(second_end - second.begin())] = middle;
    *first_end = middle;
    mesh.triangles.push_back(second);
  }
}

}  // namespace

TriMesh half_of(const TriMesh& whole) {
  TriMesh half;
  const auto count = static_cast<std::ptrdiff_t>(whole.triangles.size() / 2);
  half.triangles.assign(whole.triangles.begin(), whole.triangles.begin() + count);
  Index vertices = 0;
  for (const Triangle& t : half.triangles)
    vertices = std::max({vertices, t[0] + 1, t[1] + 1, t[2] + 1});
  half.positions.assign(whole.positions.begin(), whole.positions.begin() + vertices);
  return half;
}

TriMesh without_chords(TriMesh half, const Plane& plane) {
  const std::vector<bool> on_fold = fold_vertices(Patch(half), plane);
  std::vector<std::array<Index, 2>> sides;  // from end to end, an edge inside in both directions
  for (const Triangle& t : half.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Index v = t[k], w = t[(k + 1) % 3];
      if (on_fold[v] && on_fold[w]) sides.push_back({v, w});
    }
  }
  std::sort(sides.begin(), sides.end());
  for (const auto& [v, w] : sides) {
    if (v < w && std::binary_search(sides.begin(), sides.end(), std::array{w, v}))
      divide_edge(half, v, w);
  }
  return half;
}

Patch with_plane_as_edges(const Patch& product, const Plane& plane) {
  const double snap = k_on_plane * bounding_box_diagonal(product.mesh());
  return Patch(imprint(product, plane_section(product, plane, snap)).mesh);
}

std::optional<Patch> halved_product(const Patch& product, const Plane& plane) {
  require_symmetric(product, symmetry_in(product, plane));
  const MirrorSide side = greater_side(product.mesh(), plane);
  Patch half(without_chords(half_of(symmetric_mesh(product, plane, side).mesh), plane));
  const bool is_sound = !blocking_problem(half.inspection(), Purpose::measure) &&
                        half.inspection().topology.components == 1;
  return is_sound ? std::optional(std::move(half)) : std::nullopt;
}

}  // namespace planish
