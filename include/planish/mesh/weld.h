#pragma once

#include <cstddef>
#include <optional>

#include <planish/mesh/repair.h>
#include <planish/mesh/tri_mesh.h>

namespace planish {

/// A mesh whose borders were joined.
struct WeldedMesh : RepairedMesh {
  std::size_t joined = 0;   ///< border edges that became one with another, each pair once
  std::size_t divided = 0;  ///< border edges that were divided at a vertex of the other side
  std::size_t turned = 0;   ///< triangles of pieces that were turned over to fit
  std::size_t left = 0;     ///< border edges that lie on others and could not be joined
  std::size_t held = 0;     ///< border vertices where a third of an edge is less than the length
  double length = 0.0;      ///< of the borders that were joined, each once, model units
};

/// Joins borders that lie on each other: vertices on the border at places within the length, and
/// where a vertex lies within the length of a border edge (a T-junction), that edge, dividing its
/// triangle; both parts have it as `source`. A joined vertex has the place of the one with the
/// smallest number. Only whole edges are joined: pieces that touch at a point stay apart. Nothing
/// is joined that would collapse a triangle, give an edge a third triangle, fold the surface back
/// on itself or make it one-sided, or that is farther apart than a third of the shortest border
/// edge there. Where two pieces run the same way along their seam, the smaller is turned.
/// @param length model units, 0: places that are exactly equal; may be infinite
/// @throws Error option_out_of_range where it is below 0 or no number
WeldedMesh weld(const TriMesh& mesh, double length);

/// The length for a mesh where none is given: 1e-5 of the diagonal of the bounding box.
double default_weld_length(const TriMesh& mesh);

/// The smallest distance between the borders of two pieces, model units; nothing where no two have
/// borders. For a note where weld() joins nothing.
std::optional<double> nearest_border_gap(const TriMesh& mesh);

/// What weld() would join.
struct TouchingPieces {
  std::size_t pieces = 0;  ///< that touch others along whole sides
  std::size_t joined = 0;  ///< what they would become
  double length = 0.0;     ///< of the borders between them, each once, model units
};

/// Finds the pieces that weld() would join, for a note that names it.
/// @throws Error as weld()
TouchingPieces find_touching_pieces(const TriMesh& mesh, double length);

}  // namespace planish
