#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <planish/mesh/seams.h>

#include "mesh/match/border_lines.h"
#include "mesh/match/boundary_correspondences.h"

namespace planish {

/// A seam whose sides are matched as curves, and where it lies.
struct CurveSeam {
  Seam seam;
  /// Of each side, the edges that it runs over at least in part.
  std::array<std::vector<std::size_t>, 2> edges;
};

/// Whether two stretches of border are too short for a seam.
/// @param lengths of both
/// @param edges how many of each border
bool is_fragment(const std::array<const BorderLoop*, 2>& loops,
                 const std::array<double, 2>& lengths, const std::array<std::size_t, 2>& edges);

/// Finds such seams, also where vertices lie at the same places, by the first side's border.
/// @param tolerance as find_seams() has it
std::vector<CurveSeam> find_curve_seams(const BorderLines& borders,
                                        std::vector<BoundaryCorrespondence> correspondences,
                                        double tolerance);

}  // namespace planish
