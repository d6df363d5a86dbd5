#include <algorithm>
#include <vector>

#include <planish/core/error.h>
#include <planish/mesh/repair.h>

#include "mesh/half_edges.h"
#include "mesh/repair/repaired.h"

namespace planish {

namespace {

/// Triangles that are too low.
class Caps {
 public:
  /// @param height at the scale of the mesh, from 0
  Caps(const TriMesh& mesh, const HalfEdges& halves, double height)
      : mesh_(mesh), halves_(halves), height_(height) {}

  bool is_cap(Index triangle) const { return long_side(triangle) != HalfEdges::none; }

  /// The half-edge along the long side of a cap; none where the triangle is no cap.
  Index long_side(Index triangle) const {
    const Index first = 3 * triangle;
    Index longest = first;
    for (const Index h : {first + 1, first + 2}) {
      if (norm(along(h)) > norm(along(longest))) longest = h;
    }
    const double length = norm(along(longest));
    const double lowest = std::max(height_, k_flat * length);
    const Vec3 to = along(HalfEdges::next(longest)), from = along(HalfEdges::previous(longest));
    const bool is_low = norm(cross(to, from)) <= lowest * length;
    const bool is_obtuse = dot(to, from) > k_cosine * norm(to) * norm(from);
    return is_low && is_obtuse ? longest : HalfEdges::none;
  }

 private:
  static constexpr double k_flat = 1e-15;   // as inspect() has it
  static constexpr double k_cosine = 0.94;  // of 180 degrees without the angle

  Vec3 along(Index h) const {
    return mesh_.positions[halves_.to(h)] - mesh_.positions[halves_.from(h)];
  }

  const TriMesh& mesh_;
  const HalfEdges& halves_;
  double height_;
};

}  // namespace

FlippedMesh flip_caps(const TriMesh& mesh, double height) {
  if (!(height >= 0.0))
    throw Error(ErrorCode::option_out_of_range, "the height of caps must be a number from 0");
  FlippedMesh result{unchanged(mesh)};
  const double scale = unit_scale(mesh);
  const TriMesh unit = scaled(mesh, scale);
  HalfEdges halves(mesh);
  const Caps caps(unit, halves, scale * height);
  std::vector<Index> left;
  for (Index t = 0; t < mesh.triangles.size(); ++t) {
    if (caps.is_cap(t)) left.push_back(t);
  }
  // Each flip may give the next cap along the same side a neighbour that is none.
  for (std::size_t before = left.size() + 1; left.size() < before;) {
    before = left.size();
    std::erase_if(left, [&](Index t) {
      const Index side = caps.long_side(t);
      if (side == HalfEdges::none) return true;
      const Index twin = halves.twin(side);
      if (twin == HalfEdges::none || !halves.may_flip(side) || caps.is_cap(twin / 3)) return false;
      halves.flip(side);
      result.source[t] = result.source[twin / 3];
      ++result.flipped;
      return true;
    });
  }
  for (Index t = 0; t < mesh.triangles.size(); ++t)
    result.mesh.triangles[t] = {halves.from(3 * t), halves.from(3 * t + 1), halves.from(3 * t + 2)};
  return result;
}

}  // namespace planish
