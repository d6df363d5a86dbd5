#pragma once

#include <optional>
#include <span>

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

/// Sides of slits that cross by a hair, a thousandth of the root of the area, are moved apart. With
/// least stretch, and from there within the limits as unfold() has it.
/// @return nothing where the piece has no pattern (unfold()).
/// @throws Cancelled
std::optional<LaidFlat> laid_flat(const PanelMesh& mesh, const PieceCorners& corners,
                                  const StrainLimits& limits, const Context& context);

}  // namespace planish
