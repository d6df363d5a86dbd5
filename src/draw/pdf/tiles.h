#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <planish/draw/drawing.h>
#include <planish/draw/format_drawing.h>

namespace planish {

inline constexpr double k_tile_margin = 10.0;  ///< of a page that stays free, millimetres

/// How a sheet is divided into pages. Rows count from the top. Lengths in millimetres.
struct TileGrid {
  Vec2 page;   ///< size of the paper
  Vec2 frame;  ///< what a page shows of the sheet
  std::size_t columns = 1, rows = 1;
  Vec2 area;              ///< size of the part of the sheet that is shown
  Vec2 low = {};          ///< its lower left corner on the sheet
  double overlap = 10.0;  ///< of neighbours

  /// From one tile to the next.
  Vec2 step() const { return frame - Vec2{overlap, overlap}; }
  /// Where on the sheet the lower left corner of a tile's frame is.
  Vec2 low_of(std::size_t row, std::size_t column) const;
  /// The size of all tiles together.
  Vec2 size() const;
};

/// "B3"
std::string tile_name(std::size_t row, std::size_t column);

/// The grid with the fewest tiles over an area of that size, the paper upright or across.
TileGrid tile_grid(Vec2 area, const PageOptions& options);

/// The same over all that is drawn, with 2 mm around it; of a drawing where nothing is over the
/// sheet. The paper lies as fewer of the tiles have something on them.
TileGrid tile_grid(const Drawing& drawing, const PageOptions& options);

/// A grid on pages that are alike and no longer than that on either side, as few and as small as
/// can be; nothing where it would take more pages than anyone joins.
/// @param longest millimetres
std::optional<TileGrid> tile_grid(const Drawing& drawing, double longest);

/// For each tile, row by row, whether anything of the drawing is on it: a line, a text, or the
/// inside of what is closed.
std::vector<bool> used_tiles(const Drawing& drawing, const TileGrid& grid);

}  // namespace planish
