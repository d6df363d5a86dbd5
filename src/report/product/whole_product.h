#pragma once

#include <cstddef>
#include <string>

#include <planish/draw/color.h>
#include <planish/flatten/product.h>

#include "report/product/drawn_product.h"

namespace planish {

/// The part of a page that shows all pieces together.
struct WholeProduct {
  std::string html;  ///< a sentence, a still picture, and the pieces with their colours
  std::string data;  ///< for the script, which takes the still picture away for a view in space
};

/// Nothing where fewer than two pieces lie in one place.
WholeProduct whole_product(const ProductReport& report);

/// The data of that view; docs/report.md has the format.
std::string product_data(const ProductReport& report, const DrawnProduct& drawn);

/// The colour of a piece by its number, of twelve in turn.
Color piece_color(std::size_t patch);

/// "4 pieces, 2.9 m of seam; moves 0 mm; needs 2 % of stretch.", plain text.
std::string product_sentence(const ProductReport& report);

/// A tick, a cross or a dot for a piece, with a blank: markup.
std::string piece_mark(const PatchResult& piece);

/// The anchor of a piece on the page.
std::string piece_anchor(std::size_t patch);

/// That of a row in the table of seams, by its number from 1.
std::string seam_anchor(std::size_t number);

}  // namespace planish
