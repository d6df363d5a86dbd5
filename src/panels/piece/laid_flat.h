#pragma once

#include <array>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include <planish/unfold/unfold.h>

#include "panels/piece/panel_mesh.h"
#include "panels/piece/piece_corners.h"

namespace planish {

/// A piece of a mesh that was cut out and laid flat.
struct LaidFlat {
  Patch patch;  ///< its vertices are those of PieceCorners
  Pattern pattern;
  EdgeStrain strain = {};
};

/// What a pattern of a piece keeps.
struct PieceLimits {
  StrainLimits strain = {};
  /// As UnfoldOptions has it, but at most a thousandth of the root of the area of the piece.
  double open_crossings = std::numeric_limits<double>::max();
  int max_iterations = UnfoldOptions{}.max_iterations;  ///< 0: a conformal map
};

/// A piece as a mesh of its own, whose vertices are those of its corners.
TriMesh cut_out(const PanelMesh& mesh, const PieceCorners& corners);

/// With least stretch, and from there within the limits as unfold() has it.
/// @param seams lengths that sides along seams get where that can be, by vertices of the piece; the
///   others are free
/// @return nothing where the piece has no pattern (unfold()).
/// @throws Cancelled
std::optional<LaidFlat> laid_flat(const PanelMesh& mesh, const PieceCorners& corners,
                                  const PieceLimits& limits, const Context& context,
                                  std::span<const EdgeLength> seams = {});

/// A side of an open edge of the mesh, at the border of a piece.
struct FlatSide {
  Index edge;                 ///< of the mesh
  std::array<Index, 2> ends;  ///< vertices of the piece
  double length;              ///< in its pattern, model units
};

/// @param triangles of the piece, in the order of its corners
std::vector<FlatSide> seam_sides(const PanelMesh& mesh, const OpenEdges& open,
                                 const PieceCorners& corners, std::span<const Index> triangles,
                                 const Pattern& pattern);

}  // namespace planish
