#pragma once

#include <optional>
#include <span>

#include <planish/unfold/unfold.h>

#include "panels/piece/panel_mesh.h"
#include "panels/piece/piece_corners.h"

namespace planish {

/// A piece of a mesh that was cut out and laid flat.
struct LaidFlat {
  Patch patch;      ///< its vertices are those of PieceCorners
  Pattern pattern;  ///< of least stretch, or of less rms strain
  EdgeStrain strain = {};
};

/// Sides of slits that cross by a hair, a thousandth of the root of the area, are moved apart. With
/// least stretch, or where that misses the limit of rms strain with less of that.
/// @param limit of the rms strain; 0: none
/// @return nothing where the piece has no pattern (unfold()).
/// @throws Cancelled
std::optional<LaidFlat> laid_flat(const PanelMesh& mesh, const PieceCorners& corners, double limit,
                                  const Context& context);

}  // namespace planish
