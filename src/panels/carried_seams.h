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

/// Lays the seams of a thinned product on the product itself: each chain is made fairer and traced
/// as what is drawn over a mesh is (trace_lines()), then as imprinted_seams() does.
/// @param open of the edges of the net
/// @param most_move of its vertices when they are made fairer, mean edges of the net's mesh
CarriedSeams carried_seams(const Patch& product, const SeamNet& net, const OpenEdges& open,
                           double least_area, double most_move = 0.7);

}  // namespace planish
