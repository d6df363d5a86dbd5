#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include <planish/mesh/patch.h>
#include <planish/mesh/surface_line.h>

namespace planish {

/// The distance of a place from a plane, model units; above 0 on the side of its normal.
inline double height_over(const Plane& plane, Vec3 p) {
  return (dot(plane.normal, p) - plane.offset) / norm(plane.normal);
}

/// The place of a plane that is nearest to another one.
inline Vec3 foot_on(const Plane& plane, Vec3 p) {
  const double share = (dot(plane.normal, p) - plane.offset) / dot(plane.normal, plane.normal);
  return p - share * plane.normal;
}

/// The mirror image of a place in a plane; to the bit where that is a plane x = 0, y = 0 or z = 0.
inline Vec3 mirrored(const Plane& plane, Vec3 p) {
  const double share = (dot(plane.normal, p) - plane.offset) / dot(plane.normal, plane.normal);
  return p - (2.0 * share) * plane.normal;
}

/// The mirror image of a mesh, with the numbers of vertices and triangles, which are turned over.
TriMesh mirrored(const Plane& plane, TriMesh mesh);

/// How nearly a mesh is its own mirror image in a plane.
struct Symmetry {
  Plane plane;           ///< its normal has length 1, and its largest component is above 0
  double largest = 0.0;  ///< distance of a vertex's mirror image from the mesh, model units
  double rms = 0.0;      ///< root mean square of these distances, model units
  /// Where the mesh is symmetric vertex by vertex, to 1e-5 of its diagonal, whatever its triangles:
  /// of each vertex the one at its mirror image, which on the plane is itself, as it is where no
  /// triangle uses it. Else empty.
  std::vector<Index> image = {};
};

/// Up to which distance meshes count as symmetric: 0.5 % of the diagonal. Model units.
double symmetry_tolerance(const TriMesh& mesh);

/// Looks at a mesh in a plane. O(n log n).
/// @throws Error what stands in the way of Purpose::measure; option_out_of_range for a normal of
///   length 0 and what is no number
Symmetry symmetry_in(const Patch& patch, const Plane& plane);

/// Finds the plane in which a mesh is most nearly its own mirror image: begins with the planes
/// through the centroid of its area across the axes of space and the principal axes of inertia,
/// and with more between these where they are not distinct, and moves each until mirrored places
/// are nearest to the mesh (Besl and McKay, A method for registration of 3-D shapes, 1992; Chen and
/// Medioni, Object modelling by registration of multiple range images, 1992). Planes that are as
/// good, as of a sphere, go by that order: x before y before z. Across an axis of space, and
/// through the origin, where that is as good. Not the plane in which a flat mesh lies.
/// O(n log n).
/// @throws Error what stands in the way of Purpose::measure
Symmetry find_symmetry(const Patch& patch);

/// @param symmetry of the same patch
/// @throws Error not_symmetric where it is farther than symmetry_tolerance(), saying by how much
void require_symmetric(const Patch& patch, const Symmetry& symmetry);

/// Which part of a mesh stands for both.
enum class MirrorSide {
  above,  ///< that on the side of the plane's normal
  below,  ///< the other one
};

/// The side with more area; above where both have as much.
MirrorSide greater_side(const TriMesh& mesh, const Plane& plane);

/// A part of a line, or the mirror image of one.
struct MirroredLine {
  SurfaceLine line;          ///< on the same mesh
  std::size_t of = 0;        ///< number of the line that it comes from
  bool is_mirrored = false;  ///< it was not drawn there
};

/// Lines that are, together, their own mirror image.
struct SymmetricLines {
  std::vector<MirroredLine> lines;  ///< all of them
  /// Where more of what was given lies; nothing where both sides have as much.
  std::optional<MirrorSide> drawn_side = {};
};

/// What of lines lies on one side of a plane, or along it as symmetric_lines() takes that.
/// @throws Error as plane_section()
std::vector<MirroredLine> lines_on_side(const Patch& patch, std::span<const SurfaceLine> lines,
                                        const Plane& plane, MirrorSide side);

/// Adds the mirror images of lines. What lies along the plane, nearer than half a mean edge, is put
/// on it and is there once; lines that cross it are divided. Lines that have a counterpart on the
/// other side within the tolerance get no second one: where the mesh has vertex images the mirror
/// image of the drawn side replaces it, else it stays where it was drawn, as a crease of the mesh.
/// Mirror images are exact where vertices and triangles have theirs, else laid on the nearest
/// places of the mesh, as trace_lines() does.
/// @param symmetry of the same patch
/// @param tolerance model units
/// @throws Error as trace_lines()
SymmetricLines symmetric_lines(const Patch& patch, std::span<const SurfaceLine> lines,
                               const Symmetry& symmetry, double tolerance);

/// A mesh that is its own mirror image.
struct SymmetricMesh {
  TriMesh mesh;              ///< first the half that is kept, its vertices in their order
  std::vector<Index> image;  ///< of each vertex; on the plane itself
};

/// Cuts a mesh at a plane, keeps one side and puts its mirror image in the place of the other one.
/// Vertices of that side keep their bits, but for those at the plane, which are moved on to it.
/// @throws Error misplaced_cut where nothing lies on that side; as imprint()
SymmetricMesh symmetric_mesh(const Patch& patch, const Plane& plane, MirrorSide side);

/// How a piece of a product lies to its mirror image.
struct MirrorPiece {
  /// Which of two mirror images a piece is.
  enum class Kind {
    alone,     ///< no piece is where its mirror image is
    original,  ///< another one is its mirror image
    image,     ///< it is the mirror image of another one
    across,    ///< it is its own mirror image
  };
  Kind kind = Kind::alone;  ///< which it is
  std::size_t of = 0;       ///< of an image: the number of the other one
  double distance = 0.0;    ///< of vertices of mirror images from the piece there, the largest; of
                            ///< one that is alone to the nearest such piece. Model units
};

/// Finds which pieces are mirror images of each other, or of themselves, by their places in space:
/// triangles may differ. O(n log n), times the pieces that lie at one place.
/// @param side of the originals
/// @param tolerance of places of vertices, model units
std::vector<MirrorPiece> mirror_pieces(std::span<const TriMesh> pieces, const Plane& plane,
                                       MirrorSide side, double tolerance);

/// The same pieces, with each image as the exact mirror image of its original, and those across as
/// symmetric_mesh(). One that is so already, triangle by triangle, stays as it is.
/// @param found what mirror_pieces() found
/// @throws Error as symmetric_mesh()
std::vector<TriMesh> symmetric_pieces(std::vector<TriMesh> pieces,
                                      std::span<const MirrorPiece> found, const Plane& plane,
                                      MirrorSide side);

}  // namespace planish
