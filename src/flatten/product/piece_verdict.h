#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <planish/flatten/product.h>

namespace planish {

/// What a piece is judged by.
enum class PieceCheckOf {
  failure,            ///< whether it could be flattened at all
  rejected,           ///< whether evolving made its pattern better
  strain,             ///< a limit of strain
  deviation,          ///< the limit of how far vertices move
  angle,              ///< the limit of the smallest angle
  defect,             ///< the target of e_max
  bending,            ///< the bound of bending
  form,               ///< whether the form is smooth and kept
  overlap,            ///< whether the pattern lies over itself
  flipped_triangles,  ///< whether triangles of the pattern are flipped over
  size,               ///< whether the pattern is large enough to be one in the unit given
};

/// Lower case with underscores: "flipped_triangles".
std::string_view to_string(PieceCheckOf what);

/// One thing that a piece is judged by.
struct PieceCheck {
  PieceCheckOf what = PieceCheckOf::failure;
  bool met = false;
  std::string text;  ///< in a few words, plain UTF-8 text: "strain limit of 5 % missed: 8.1 %"
};

/// All limits that were asked for, and what is wrong with the piece besides: what is missed first.
/// Empty where nothing was asked for and nothing is wrong.
std::vector<PieceCheck> piece_checks(const PatchResult& piece);

/// Whether a pattern can be handed out as it was asked for: it is there and no check is missed.
bool is_met(const PatchResult& piece);

/// "front - back", or of one piece "two sides of sleeve". Plain text.
std::string near_borders_name(const ProductReport& report, const NearBorders& near);

/// Which side of a seam is longer and by how much, in the pattern and on the model: "back is 3.02
/// mm longer in the pattern". Empty where both are equal. Plain text.
std::string easing_text(const ProductReport& report, const MeasuredSeam& seam);

/// The numbers of the pieces: those that failed, those that miss something, the others; in their
/// order.
std::vector<std::size_t> missed_first(const ProductReport& report);

}  // namespace planish
