#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <planish/core/error.h>
#include <planish/sheet/nest_sheet.h>

#include "core/job.h"
#include "pattern/polygon/loop_box.h"
#include "sheet/annotations.h"
#include "sheet/layout/laid_pieces.h"
#include "sheet/sheet_layout.h"

namespace planish {

namespace {

constexpr double k_around = 2.0;  // that pages show around what is drawn, millimetres
constexpr double k_label_height = k_around + sheet::k_inch_square + sheet::k_gap;

Path square_at(Vec2 low, double side) {
  return {{{low, {low.x + side, low.y}, low + Vec2{side, side}, {low.x, low.y + side}}},
          true,
          Stroke{sheet::k_label_color}};
}

std::string pieces_text(const Nesting& nesting) {
  const std::size_t count = nesting.placements.size();
  return std::to_string(count) + (count == 1 ? " piece" : " pieces");
}

/// Below the pieces, which lie above it: what the first of several pages says.
Layer page_label(const NestJob& job, const Nesting& nesting, const std::string& title,
                 const std::string& lines) {
  constexpr double low = k_around, second = sheet::k_square + sheet::k_gap;
  constexpr double left = second + sheet::k_inch_square + sheet::k_gap;
  Layer layer{
      "label",
      {square_at({0.0, low}, sheet::k_square), square_at({second, low}, sheet::k_inch_square)}};
  const auto line = [&](Vec2 at, double height, std::string text) {
    layer.shapes.emplace_back(Text{at, height, std::move(text), sheet::k_label_color});
  };
  line({3.0, low + 4.0}, 3.0, "50 mm");
  line({second + 3.0, low + 4.0}, 3.0, "2 in");
  line({left, low + 42.0}, 6.0, title);
  line({left, low + 33.0}, 3.0, pieces_text(nesting));
  line({left, low + 27.0}, 2.5, "Print at 100 % (\"actual size\") and measure the squares.");
  line({left, low + 21.0}, 2.2, lines);
  const std::string date = job.patches.empty() ? "" : job.patches.front().annotations.date;
  if (!date.empty()) line({left, low + 15.0}, 2.5, date);
  return layer;
}

Drawing drawing_of(const NestJob& job, Nesting nesting, const std::string& title) {
  for (NestPlacement& placement : nesting.placements)
    placement.shift.y += k_label_height;
  Drawing sheet = laid_pieces(job, nesting, 0);
  sheet.title = title;
  sheet.width = std::max(nesting.used_length, 1.0);
  sheet.height = k_label_height + job.sheets.width;
  const std::string lines = line_words(sheet.layers);
  add_below_cut(sheet, page_label(job, nesting, title, lines));
  sheet.notes = {pieces_text(nesting), lines};
  return sheet;
}

/// Widths of rolls that rows of pages make.
class PageWidths {
 public:
  explicit PageWidths(const PageOptions& pages) : pages_(pages) {}

  /// The width for a number of rows. For 0 rows: that of one page which also has the label.
  double of(std::size_t rows, bool across) const {
    const PageRoom room = page_room(pages_, across);
    const double around = 2.0 * k_around;
    if (rows == 0) return room.frame.y - k_label_height - around;
    return room.frame.y + static_cast<double>(rows - 1) * room.step.y - around;
  }

 private:
  PageOptions pages_;
};

struct PagesFound {
  Drawing drawing;
  std::size_t pages = 0;
  double longest = 0.0;  ///< side of the drawing

  /// Of as many pages the shape that is easier to lay out on a table.
  bool is_better_than(const PagesFound& other) const {
    return pages != other.pages ? pages < other.pages : longest < other.longest;
  }
};

/// Nothing where a piece does not fit on a roll of that width.
std::optional<Nesting> laid_on(const std::vector<NestPiece>& pieces, const NestOptions& sheets,
                               const Context& context) {
  if (!(sheets.width > 0.0)) return std::nullopt;
  try {
    return nest(pieces, sheets, context);
  } catch (const Error& error) {
    if (error.code() != ErrorCode::piece_too_large) throw;
    return std::nullopt;
  }
}

/// Of a square as large as the boxes of all pieces.
double side_of_boxes(const std::vector<NestPiece>& pieces) {
  double area = 0.0;
  for (const NestPiece& piece : pieces) {
    if (piece.quantity == 0) continue;
    const Vec2 size = loop_box(piece.outline.loops).size();
    area += piece.quantity * size.x * size.y;
  }
  return std::sqrt(area);
}

}  // namespace

Drawing page_sheet(NestJob job, const PageOptions& pages, const std::string& title,
                   const Context& context) {
  constexpr std::size_t most_rows = 200, enough = 5;
  const std::vector<NestPiece> pieces = nest_pieces(job);
  const PageWidths widths(pages);
  // A roll wider than that has its pieces in one row.
  const double widest = 2.0 * side_of_boxes(pieces);
  job.sheets.length.reset();
  job.sheets.margin = 0.0;
  std::optional<PagesFound> best;
  PartsOfJob parts(context);
  for (const bool across : {false, true}) {
    std::size_t found = 0;
    for (std::size_t rows = 0; rows <= most_rows && found < enough; ++rows) {
      job.sheets.width = widths.of(rows, across);
      if (found > 0 && job.sheets.width > widest) break;
      const auto nesting = laid_on(pieces, job.sheets, parts.next(0.1));
      if (!nesting) continue;
      if (rows > 0) ++found;
      Drawing drawing = drawing_of(job, *nesting, title);
      const double longest = std::max(drawing.width, drawing.height);
      const std::size_t count = count_pages(drawing, pages);
      PagesFound some{std::move(drawing), count, longest};
      if (!best || some.is_better_than(*best)) best = std::move(some);
    }
  }
  if (!best) {
    throw Error(ErrorCode::too_large,
                "no pages of " + pages.paper.name +
                    " take the pieces: check their unit, or take larger paper");
  }
  return std::move(best->drawing);
}

}  // namespace planish
