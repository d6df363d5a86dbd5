#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include <planish/mesh/patch.h>
#include <planish/mesh/surface_line.h>

#include "mesh/search/closest_point.h"

namespace planish {

/// Places on a mesh, evenly over its area, the same every time.
/// @param mesh has an area
std::vector<Vec3> even_places(const TriMesh& mesh, std::size_t count);

/// Places along the border of a patch, evenly over its length; none of a closed one.
/// @param positions of its vertices, at any scale
std::vector<Vec3> even_border_places(const Patch& patch, std::span<const Vec3> positions,
                                     std::size_t count);

/// A plane, and how far mirrored places are from the mesh.
struct MirrorFit {
  Plane plane;
  double rms = 0.0;
};

/// The plane, of those near one, in which places have mirror images nearest to partners.
Plane plane_between(std::span<const Vec3> places, std::span<const Vec3> partners,
                    const Plane& near);

/// Moves planes until mirrored places are nearest to a mesh.
class MirrorFitting {
 public:
  /// @param surface of the mesh, and
  /// @param normals of its triangles, of length 1 or 0; both must outlive it
  /// @param places on it
  /// @param middle of the mesh, about which planes turn
  MirrorFitting(const ClosestPointTree& surface, std::span<const Vec3> normals,
                std::vector<Vec3> places, Vec3 middle)
      : surface_(surface), normals_(normals), places_(std::move(places)), middle_(middle) {}

  MirrorFit fit_of(const Plane& plane) const;
  /// Rounds towards closest places, which always come nearer, and then by Newton's method towards
  /// the surfaces there, as long as it gains.
  MirrorFit refined(const Plane& plane, int rounds, int newton_steps) const;

 private:
  /// Mirrored places and what is nearest to them.
  struct Pairs {
    std::vector<Vec3> mirrored;
    std::vector<ClosestPoint> closest;
    double rms = 0.0;
  };
  Pairs pairs_of(const Plane& plane) const;
  Plane moved_to_closest(const Plane& plane, const Pairs& pairs) const;
  Plane newton_step(const Plane& plane, const Pairs& pairs) const;

  const ClosestPointTree& surface_;
  std::span<const Vec3> normals_;
  std::vector<Vec3> places_;
  Vec3 middle_;
};

}  // namespace planish
