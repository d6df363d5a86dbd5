#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <span>
#include <utility>
#include <vector>

#include <planish/mesh/imprint.h>
#include <planish/mesh/repair.h>
#include <planish/mesh/symmetry.h>

#include "mesh/match/symmetric_whole.h"

namespace planish {

namespace {

using EdgeEnds = std::array<Index, 2>;

EdgeEnds edge_of(const Triangle& t, std::size_t k) {
  return {std::min(t[k], t[(k + 1) % 3]), std::max(t[k], t[(k + 1) % 3])};
}

std::vector<EdgeEnds> edges_of(std::span<const Triangle> triangles) {
  std::vector<EdgeEnds> edges;
  edges.reserve(3 * triangles.size());
  for (const Triangle& t : triangles) {
    for (std::size_t k = 0; k < 3; ++k)
      edges.push_back(edge_of(t, k));
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

/// The triangles on one side, and the others.
struct Sides {
  std::vector<Triangle> kept, dropped;
};

/// @param sign 1 to keep those above the plane, -1 to keep those below
Sides sides_of(const ImprintedMesh& cut, const Plane& plane, double snap, double sign) {
  std::vector<double> heights;
  heights.reserve(cut.mesh.positions.size());
  for (const Vec3 p : cut.mesh.positions) {
    const double height = sign * height_over(plane, p);
    heights.push_back(std::abs(height) <= snap ? 0.0 : height);
  }
  for (const std::vector<Index>& path : cut.paths) {
    for (const Index v : path)
      heights[v] = 0.0;
  }
  Sides sides;
  for (const Triangle& t : cut.mesh.triangles) {
    const bool is_kept = heights[t[0]] + heights[t[1]] + heights[t[2]] > 0.0;
    (is_kept ? sides.kept : sides.dropped).push_back(t);
  }
  return sides;
}

/// The part of a mesh on one side.
struct Half {
  TriMesh mesh;
  std::vector<bool> is_on_fold;  ///< of each vertex: at the end of an edge where the other side was
};

/// Without vertices that no triangle uses. Where parts touch at a point, each has a vertex there.
Half half_of(const ImprintedMesh& cut, const Sides& sides) {
  const std::vector<EdgeEnds> kept = edges_of(sides.kept), dropped = edges_of(sides.dropped);
  std::vector<EdgeEnds> fold;
  std::set_intersection(kept.begin(), kept.end(), dropped.begin(), dropped.end(),
                        std::back_inserter(fold));
  constexpr Index none = static_cast<Index>(-1);
  std::vector<Index> number(cut.mesh.positions.size(), none);
  for (const Triangle& t : sides.kept) {
    for (const Index v : t)
      number[v] = 0;
  }
  TriMesh used{{}, sides.kept};
  for (Index v = 0; v < number.size(); ++v) {
    if (number[v] == none) continue;
    number[v] = static_cast<Index>(used.positions.size());
    used.positions.push_back(cut.mesh.positions[v]);
  }
  for (Triangle& t : used.triangles) {
    for (Index& v : t)
      v = number[v];
  }
  SeparatedMesh parts = separate_touching(used);
  Half half{std::move(parts.mesh), {}};
  half.is_on_fold.assign(half.mesh.positions.size(), false);
  for (std::size_t t = 0; t < half.mesh.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (!std::binary_search(fold.begin(), fold.end(), edge_of(sides.kept[t], k))) continue;
      half.is_on_fold[half.mesh.triangles[t][k]] = true;
      half.is_on_fold[half.mesh.triangles[t][(k + 1) % 3]] = true;
    }
  }
  return half;
}

}  // namespace

SymmetricMesh symmetric_mesh(const Patch& patch, const Plane& plane, MirrorSide side) {
  const double snap = k_on_plane * bounding_box_diagonal(patch.mesh());
  const ImprintedMesh cut = imprint(patch, plane_section(patch, plane, snap));
  const Sides sides = sides_of(cut, plane, snap, side == MirrorSide::above ? 1.0 : -1.0);
  if (sides.kept.empty()) {
    throw Error(ErrorCode::misplaced_cut,
                "nothing lies on the side of the plane of symmetry that is to be kept");
  }
  Half half = half_of(cut, sides);
  return with_mirror_image(std::move(half.mesh), half.is_on_fold, plane);
}

}  // namespace planish
