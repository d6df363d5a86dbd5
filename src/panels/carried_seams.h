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

/// Lays the seams of a thinned product on the product itself: each chain is made fairer and traced
/// as what is drawn over a mesh is (trace_lines()), then as imprinted_seams() does.
/// @param open of the edges of the net
CarriedSeams carried_seams(const Patch& product, const SeamNet& net, const OpenEdges& open,
                           double least_area);

}  // namespace planish
