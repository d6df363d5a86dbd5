#pragma once

#include <cstddef>

#include <planish/sheet/nest_sheet.h>

namespace planish {

/// The pieces that lie on one sheet, on the layers of a pattern, without words about the sheet. Its
/// size is left open.
/// @param number of the sheet, from 0
Drawing laid_pieces(const NestJob& job, const Nesting& nesting, std::size_t number);

/// Adds a layer below what is cut.
void add_below_cut(Drawing& sheet, Layer layer);

}  // namespace planish
