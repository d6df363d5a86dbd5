#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <planish/core/vec.h>
#include <planish/mesh/symmetry.h>
#include <planish/mesh/tri_mesh.h>

namespace planish {

/// The vertices of a patch that is its own mirror image, in orbits: a vertex above the plane with
/// its image below, or one that lies on the plane. Of any other patch each vertex is an orbit by
/// itself. The first vertex of an orbit is the one that is not below; orbits have the order of
/// their first vertices.
class MirrorOrbits {
 public:
  MirrorOrbits() = default;
  /// @param image of each vertex, on the plane itself
  /// @param below by vertex, 1 for those below the plane
  /// @param normal of the plane, of length 1
  MirrorOrbits(std::vector<Index> image, std::vector<unsigned char> below, Vec3 normal);

  /// False where each vertex is an orbit by itself.
  bool is_symmetric() const { return !image_.empty(); }
  /// Orbits of the vertices before a number, which are their own mirror image.
  std::size_t count(std::size_t vertices) const;
  Index orbit_of(Index v) const { return image_.empty() ? v : orbit_of_[v]; }
  Index first_of(Index orbit) const { return image_.empty() ? orbit : first_[orbit]; }
  Index image(Index v) const { return image_.empty() ? v : image_[v]; }
  bool is_below(Index v) const { return !image_.empty() && below_[v] != 0; }
  bool is_on_plane(Index v) const { return !image_.empty() && image_[v] == v; }

  /// Of the plane, of length 1.
  Vec3 normal() const { return plane_.normal; }

  /// A vector at a vertex as it is at the first one of its orbit, or the other way: mirrored below
  /// the plane, and of one on the plane its part along the plane.
  Vec3 carried(Index v, Vec3 a) const {
    if (image_.empty() || (image_[v] != v && below_[v] == 0)) return a;
    return image_[v] == v ? foot_on(plane_, a) : mirrored(plane_, a);
  }
  /// The mean of moves and of their mirror images.
  /// @param moves by vertex, of all or of the inner ones
  std::vector<Vec3> symmetric(const std::vector<Vec3>& moves) const;
  /// Those of a patch over some of the vertices.
  /// @param source vertex there -> vertex here, with the images of all
  MirrorOrbits of_part(std::span<const Index> source) const;

 private:
  std::vector<Index> image_, orbit_of_, first_;
  std::vector<unsigned char> below_;
  Plane plane_;  // through the origin
};

/// Of a mesh whose triangles have mirror images too, none of them with corners on both sides of
/// the plane; else none is symmetric.
/// @param symmetry of the vertices of the mesh
MirrorOrbits mirror_orbits(const TriMesh& mesh, const Symmetry& symmetry);

/// The mean of a move and of the mirror image of another one; that of the other way round is its
/// mirror image, to the bit where mirrored() is.
/// @param normal of the plane
Vec3 symmetric_move(Vec3 own, Vec3 other, Vec3 normal);

}  // namespace planish
