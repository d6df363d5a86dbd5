#pragma once

#include <vector>

#include <planish/pattern/allowance.h>

namespace planish {

/// The darts of an outline: two straight edges of one length, but for 2 % and 1 mm, that meet in a
/// corner turned inwards by an angle of at most 90 degrees, with nothing of the piece between them.
/// `toward_to` is not set.
std::vector<FoldedDart> darts_of(const PieceOutline& outline);

/// A stretch of a loop by its points, from the first on to the last.
struct LoopStretch {
  std::size_t loop = 0, from = 0, to = 0;
};

/// All darts, each folded toward that of the stretches which is nearer to it along the border.
std::vector<FoldedDart> darts_toward(const PieceOutline& outline,
                                     const std::vector<LoopStretch>& stretches);

/// The outline with the legs of darts drawn straight.
PieceOutline with_straight_darts(PieceOutline outline, const std::vector<FoldedDart>& darts);

/// The allowance without those of the legs of folded darts, at whose lines all others end.
Allowance without_darts(const PieceOutline& outline, Allowance allowance);

/// An outline with its allowances where the cloth of folded darts is left: once more what lies
/// beside the dart on the side that it is folded toward, mirrored in that leg, and the mirror image
/// of this in the middle of the dart. So all edges lie on each other when the dart is sewn and
/// folded.
/// @param outline from with_straight_darts()
/// @param lines the outline with without_darts()
std::vector<Polygon> with_darts(const PieceOutline& outline, const std::vector<FoldedDart>& darts,
                                std::vector<Polygon> lines);

}  // namespace planish
