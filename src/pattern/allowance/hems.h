#pragma once

#include <vector>

#include <planish/pattern/allowance.h>

namespace planish {

/// The allowance without those of hems, beside which all others end at the lines of the hems.
Allowance without_hems(Allowance allowance);

/// The outline with its hems drawn straight.
/// @throws Error misplaced_allowance for a hem that is not straight, option_out_of_range for one
///   that is wider than the piece behind it is deep
PieceOutline with_straight_hems(PieceOutline outline, const Allowance& allowance);

/// An outline with its other allowances, and hems: what is folded over at the line of a hem is the
/// mirror image of what lies behind it, so that both lie on each other.
/// @param outline from with_straight_hems()
/// @param lines the outline with without_hems()
std::vector<Polygon> with_hems(const PieceOutline& outline, const Allowance& allowance,
                               std::vector<Polygon> lines);

}  // namespace planish
