#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <planish/mesh/seams.h>
#include <planish/mesh/tri_mesh.h>

namespace planish {

// The functions of this header and of weld.h leave their input as it is. Those that return a mesh
// keep the number of every vertex, used or not, and the order of triangles; new vertices and
// triangles come behind all others. Lengths are in model units. Results do not depend on the size
// or the position of the model. Time is O((n + m) log m); closing a hole of k edges adds O(k^3).
//
// All throw Error index_out_of_range or non_finite_coordinate where a mesh has such entries, and
// accept any other mesh, also an empty one.

/// A mesh that was mended, with where everything in it comes from.
struct RepairedMesh {
  /// In `source`: a triangle that is new.
  static constexpr Index none = static_cast<Index>(-1);

  TriMesh mesh;                      ///< the mended one
  std::vector<Index> source;         ///< of each triangle: the one of the input, or none
  std::vector<Index> vertex_source;  ///< of each vertex: the one of the input that it is or copies
};

/// A mesh without triangles that add nothing to its surface.
struct CleanedMesh : RepairedMesh {
  std::size_t collapsed = 0;  ///< triangles that named a vertex twice
  std::size_t repeated = 0;   ///< triangles that were there already, in the same orientation
  std::size_t backs = 0;      ///< triangles of the back of a doubled sheet
  std::size_t fins = 0;       ///< triangles of crumbs that stood on edges of a whole surface

  /// How many triangles were left out.
  std::size_t removed() const { return collapsed + repeated + backs + fins; }
};

/// Leaves out what cannot change the surface: triangles that name a vertex twice; triangles that
/// are there already, also as the other two triangles of the same quadrilateral; a piece all of
/// whose triangles are there already in other pieces, in either orientation, and the back of a
/// sheet that has both; and fins: pieces of less than 1 % of the area that hang only on edges which
/// have two triangles without them. Such pieces may have other vertices at equal places, and where
/// they reach as far as each other also within default_weld_length(), and other diagonals. What
/// comes first stays. Triangles without area that have three vertices stay, as their neighbours
/// need them, and so do a copy of a part of a piece and a single pair of opposite triangles, which
/// inspect() refuses.
CleanedMesh remove_redundant_triangles(const TriMesh& mesh);

/// A mesh in which parts that touched have vertices of their own.
struct SeparatedMesh : RepairedMesh {
  std::size_t places = 0;  ///< vertices or edges at which it was divided
};

/// Gives every fan of triangles a vertex of its own where several share one without sharing an
/// edge: holes that touch are separate holes, and so are two pieces that touch at a point. The fan
/// with the first triangle keeps the vertex. The surface does not change.
SeparatedMesh separate_touching(const TriMesh& mesh);

/// Parts the sheets that meet at edges of three and more triangles: there every triangle gets a
/// border of its own. Sheets that no other edge holds together become pieces. The surface does not
/// change. Vertices at which fans touch are separated, as by separate_touching(). `places` counts
/// the edges.
SeparatedMesh divide_at_nonmanifold_edges(const TriMesh& mesh);

/// A mesh whose triangles agree on what is outside.
struct OrientedMesh : RepairedMesh {
  std::size_t turned = 0;  ///< triangles that were turned over
};

/// Turns over the triangles that are oriented against their neighbours: in every piece connected by
/// edges of two triangles the minority, in a tie those that disagree with the first triangle. A
/// piece with one side only (a Moebius strip) stays as it is.
OrientedMesh orient_consistently(const TriMesh& mesh);

/// The same surface with its inner side outside: every triangle turned over.
TriMesh turned_over(TriMesh mesh);

/// The pieces that are inside out against their neighbours, in increasing order: sewn borders of
/// pieces with the same side outside run in opposite directions along their seam. Of pieces that
/// hang together by seams the smaller area is turned, in a tie that without the first piece. Where
/// seams contradict each other, the longer ones count.
/// @param seams what find_seams() found among the pieces; darts do not count
/// @throws Error as Patch
std::vector<std::size_t> find_inside_out(std::span<const TriMesh> pieces,
                                         std::span<const Seam> seams);

/// A mesh whose caps were flipped away.
struct FlippedMesh : RepairedMesh {
  std::size_t flipped = 0;  ///< caps that became parts of a neighbour, which is their source
};

/// Flips the long side of each cap, a triangle with an angle above 160 degrees and nearly without
/// height, so that this corner divides the neighbour beyond the side. The surface moves by at most
/// the height. A cap stays where its long side is at the border or where the other diagonal is an
/// edge already.
/// @param height of the highest cap above its long side, model units, from 0
/// @throws Error option_out_of_range
/// @pre an oriented manifold
FlippedMesh flip_caps(const TriMesh& mesh, double height);

/// A mesh some of whose holes were closed.
struct FilledMesh : RepairedMesh {
  std::size_t filled = 0;  ///< holes that were closed; their triangles have no source
  std::size_t left = 0;    ///< holes short enough that no sound triangles would close
};

/// Closes holes of up to 500 edges without new vertices, by triangles that go on as smoothly as can
/// be, and of these by the shortest edges. A hole is a loop of the border that is not the outer one
/// of its piece: that which reaches farthest. Holes that touch are closed each by itself, and get
/// the vertex there in common. The sides of a slit inside, which lie on each other, become one; a
/// slit from the outer border is a cut, and stays. A hole that only a fold or a triangle without
/// area would close stays.
/// @param length the longest border, model units, of a hole that is closed; above 0, may be
///   infinite
/// @throws Error option_out_of_range
/// @pre the mesh is an oriented manifold; else nothing is closed
FilledMesh fill_holes(const TriMesh& mesh, double length);

/// Pieces that are too small to be meant.
struct Crumbs {
  std::vector<Index> triangles;  ///< all of theirs, in increasing order
  std::size_t pieces = 0;        ///< how many
  double area_share = 0.0;       ///< of the area of the mesh that they hold, 0 to 0.1
};

/// Finds the pieces (connected by edges) that hold less than 1 % of the area each, where what is
/// left holds 90 % or more. Else nothing is a crumb: a mesh of many small pieces is meant so.
Crumbs find_crumbs(const TriMesh& mesh);

/// The mesh without some triangles.
/// @param triangles in increasing order
RepairedMesh without_triangles(const TriMesh& mesh, std::span<const Index> triangles);

}  // namespace planish
