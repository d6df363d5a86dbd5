#pragma once

#include <optional>
#include <span>
#include <vector>

#include <planish/pattern/nest.h>

#include "pattern/polygon/column_spans.h"

namespace planish {

/// A piece in one of the turns that it may take. Its box begins at (0, 0).
struct TurnedPiece {
  double angle = 0.0;                    ///< degrees, at least 0 and less than 360
  Vec2 low = {};                         ///< where the box begins before it is shifted to (0, 0)
  Vec2 size = {};                        ///< of the box
  ColumnSpans columns = {}, grown = {};  ///< of the piece, and of all within the gap around it
};

/// The lower left corner of the area of a sheet that pieces may take.
inline Vec2 corner_of(const NestOptions& options) {
  return {options.margin, options.folded ? 0.0 : options.margin};
}

/// The width of that area.
inline double width_of(const NestOptions& options) {
  return options.width - options.margin - corner_of(options).y;
}

/// The width of the columns, millimetres: what is asked for, else by the sizes of the pieces.
double column_step(std::span<const NestPiece> pieces, const NestOptions& options);

/// A width of columns of which the boxes that pieces fill, each with the gap behind it, are whole
/// multiples: then such pieces fill a sheet to its end. Where there is none near `step`, one that
/// suits those with the largest area. Nothing where no piece fills its box.
/// @param step what column_step() says
std::optional<double> step_of_boxes(std::span<const NestPiece> pieces, const NestOptions& options,
                                    double step);

/// Whether every piece fits on a sheet in one of its turns.
bool all_fit(std::span<const NestPiece> pieces, const NestOptions& options);

/// The piece in those turns in which it fits on a sheet.
/// @throws Error piece_too_large where there are none
std::vector<TurnedPiece> turned_pieces(const NestPiece& piece, const NestOptions& options,
                                       double step);

}  // namespace planish
