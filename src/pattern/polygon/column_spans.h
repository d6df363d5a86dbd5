#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <planish/pattern/piece_outline.h>

namespace planish {

/// What lies between two heights, millimetres.
struct Span {
  double low = 0.0, high = 0.0;
};

/// An area, column by column: in each of them spans of height, from the lowest up, that do not meet
/// each other. Every place of the area is in one of them; what else they hold is beside it in the
/// same column.
struct ColumnSpans {
  std::ptrdiff_t first = 0;                ///< the number of the first column
  std::vector<std::vector<Span>> columns;  ///< number k is from k to k + 1 steps
};

/// The columns of all that is no farther from a piece than the reach. Places within 0.0000001 mm of
/// the border of a column may count as either column's.
/// @param loops of the piece; where they wind around is inside
/// @param step the width of a column, millimetres
ColumnSpans column_spans(std::span<const Polygon> loops, double step, double reach);

}  // namespace planish
