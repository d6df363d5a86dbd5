#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <planish/flatten/product.h>

namespace planish {

/// One thing that a piece is judged by, in words.
struct PieceCheck {
  Criterion what = Criterion::failure;
  bool met = false;
  std::string text;  ///< in a few words, plain UTF-8 text: "strain limit of 5 % missed: 8.1 %"
};

/// All limits that were asked for, and what is wrong with the piece besides: what Outcome::missed
/// has comes first. Empty where nothing was asked for and nothing is wrong.
std::vector<PieceCheck> piece_checks(const PatchResult& piece);

/// Of each figure the largest of all finished pieces.
EdgeStrain largest_strain(const ProductReport& report);

/// What sheet takes all finished pieces, where no limit of strain was given, which piece needs
/// most, and whether no form was changed. Plain UTF-8 text, sentences; empty where there is nothing
/// to say.
std::string product_verdict(const ProductReport& report);

/// "front - back", or of one piece "two sides of sleeve". Plain text.
std::string near_borders_name(const ProductReport& report, const NearBorders& near);

/// Which side of a seam is longer and by how much, in the pattern and on the model: "back is 3.02
/// mm longer in the pattern". Empty where both are equal. Plain text.
std::string easing_text(const ProductReport& report, const MeasuredSeam& seam);

/// The numbers of the pieces: those that failed, those that miss something, the others; in their
/// order.
std::vector<std::size_t> missed_first(const ProductReport& report);

}  // namespace planish
