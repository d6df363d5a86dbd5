#pragma once

#include <span>
#include <string_view>
#include <vector>

#include <planish/pattern/offset_outline.h>

namespace planish {

/// The allowance of a stretch of the border: from a vertex on, the piece on the left, to another
/// one; all around where both are the same.
struct EdgeAllowance {
  Index from = 0, to = 0;
  double width = 0.0;  ///< millimetres; 0 for none, as along a fold
};

/// Checks that the ends are on one loop of the border, which needs no pattern.
/// @param border loops of vertices
/// @throws Error misplaced_allowance naming the piece and the vertices
void check_edge_allowances(std::span<const std::vector<Index>> border,
                           std::span<const EdgeAllowance> edges, std::string_view piece);

/// The allowance with other widths along stretches; where they overlap, the last one counts.
/// @param outline with vertices
/// @throws Error as check_edge_allowances()
Allowance with_edge_allowances(Allowance allowance, const PieceOutline& outline,
                               std::span<const EdgeAllowance> edges);

}  // namespace planish
