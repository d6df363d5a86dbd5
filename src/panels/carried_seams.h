#pragma once

#include <span>

#include <planish/mesh/patch.h>
#include <planish/mesh/surface_line.h>

#include "panels/division.h"

namespace planish {

/// A net of seams, and which of its edges are open.
struct CarriedSeams {
  SeamNet net;
  OpenEdges open;
};

/// Makes lines edges of a mesh, seams all of them. Parts that open ones divide off are joined to
/// others if they are below the least area.
/// @param is_open of each line
CarriedSeams imprinted_seams(const Patch& patch, std::span<const SurfaceLine> lines,
                             std::span<const unsigned char> is_open, double least_area);

/// The vertex of the border that is nearest to a place. @pre there is a border
Index nearest_on_border(const Patch& patch, Vec3 place);

/// How far seams may leave their places to become fair lines.
struct SeamMoves {
  double straightened = 0.7;  ///< vertices of the net move so far at most, its mean edges
  double tight = 0.0;         ///< SeamTracer::fair(): length of a part, mean edges of the product
  int rounds = 0;             ///< of it
};

/// Lays the seams of a thinned product on the product itself: each chain is made straighter, traced
/// as what is drawn over a mesh is and drawn tight in parts (SeamTracer), then as imprinted_seams()
/// does. Along creases seams stay.
/// @param open of the edges of the net
CarriedSeams carried_seams(const Patch& product, const SeamNet& net, const OpenEdges& open,
                           double least_area, const SeamMoves& moves = {});

}  // namespace planish
