#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include <planish/core/context.h>
#include <planish/mesh/tri_mesh.h>

namespace planish {

/// A turn with a shift, or with a mirror too.
struct RigidMotion {
  std::array<Vec3, 3> rows = {Vec3{1.0, 0.0, 0.0}, Vec3{0.0, 1.0, 0.0}, Vec3{0.0, 0.0, 1.0}};
  Vec3 shift = {};

  Vec3 operator()(Vec3 p) const { return of_direction(p) + shift; }
  Vec3 of_direction(Vec3 d) const { return {dot(rows[0], d), dot(rows[1], d), dot(rows[2], d)}; }
};

/// How one mesh lies over another one.
struct MeshMatch {
  bool mirrored = false;      ///< the second one is a mirror image of the first
  std::vector<Index> vertex;  ///< of the first mesh -> of the second
  RigidMotion motion;         ///< brings the first onto the second; a mirror where that is one
};

/// A mesh that is another one again, somewhere else and with other numbers.
struct MeshTwin {
  std::size_t of = 0;  ///< number of the other one, which is no twin itself
  MeshMatch match;     ///< from that one to this
};

/// As a share of the diagonal of the bounding box. Rounding to 32-bit floats is a hundredth of it.
inline constexpr double k_twin_tolerance = 1e-5;

/// Finds which meshes are equal to an earlier one or mirror images of it, whatever the numbers of
/// their vertices and triangles and wherever they lie: triangles correspond, lengths of edges
/// differ by no more than the tolerance, and after the best rigid motion so do places. What is both
/// equal and a mirror image, as of a symmetrical patch, counts as equal. Where several matches are
/// possible, it is the one of the first vertices along the border: the same every time.
///
/// Only meshes of one part with one border have twins; what Patch refuses has none. Each two
/// meshes of equal numbers of vertices and triangles are compared in linear time: wrong starts
/// along the border end early, and after some 64 walks' worth of steps there is no match.
/// @param meshes none of them null
/// @param tolerance as a share of the diagonal of the bounding box of the earlier mesh
/// @throws Cancelled
/// @return one for each mesh; none for the first of its kind
std::vector<std::optional<MeshTwin>> find_twins(std::span<const TriMesh* const> meshes,
                                                double tolerance = k_twin_tolerance,
                                                const Context& context = {});

}  // namespace planish
