#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "mesh/match/border_lines.h"

namespace planish {

/// Two places of borders that lie at one place of space: a vertex, and the nearest place of an edge
/// that runs along there.
struct BoundaryCorrespondence {
  std::array<std::size_t, 2> loops;  ///< numbers; the lower one first
  std::array<double, 2> at;          ///< places on them, from 0 to below their counts
  bool reversed = false;             ///< the second loop runs the other way there
};

/// How far a border's edge may be from what lies beside it.
/// @param tolerance model units; 0: a tenth of the edge's length or that of a longer neighbour
double search_radius(const BorderLines& borders, std::size_t edge, double tolerance);

/// Vertices as near to each other as this count as equal: a tenth of the mean edge at most.
double vertex_tolerance(const BorderLines& borders, double tolerance);

/// Finds such places: for each vertex and each stretch of border that passes within the reach of
/// one of its edges in nearly the same direction, the nearest: a vertex, where that is equal. Two
/// places of one loop stand there
/// in both orders. Not found are places that are only divided by a strip of their own patch, and
/// those that are neighbours on their loop. O(n log n), times the number of edges within the reach.
std::vector<BoundaryCorrespondence> find_boundary_correspondences(const BorderLines& borders,
                                                                  double tolerance);

}  // namespace planish
