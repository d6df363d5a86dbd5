#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <planish/draw/format_drawing.h>

#include "core/number_text.h"
#include "draw/pdf/divided_pdf.h"
#include "draw/pdf/pdf_content.h"
#include "draw/pdf/pdf_document.h"
#include "draw/pdf/tiles.h"
#include "pattern/polygon/loop_box.h"

namespace planish {

namespace {

// Everything in millimetres.
constexpr double k_cross = 4.0;        // half of a registration mark
constexpr double k_note_height = 2.5;  // of texts in the margin
constexpr double k_title = 14.0;       // of the first page, down to the advice
constexpr double k_line = 6.0;         // of the advice
constexpr double k_map_bottom = 64.0;  // of the first page, for the test squares
constexpr double k_inch = 25.4;

constexpr Color k_black = {0, 0, 0};
constexpr Color k_grey = {140, 140, 140};
constexpr Color k_blue = {0, 0, 200};

constexpr std::string_view k_sheet = "Sheet";

Path rectangle(Vec2 low, Vec2 size, Color color, double width) {
  const Vec2 high = low + size;
  return {{{low, {high.x, low.y}, high, {low.x, high.y}}}, true, Stroke{color, width}};
}

Path cross_at(Vec2 at) {
  return {{{{at.x - k_cross, at.y}, {at.x + k_cross, at.y}},
           {{at.x, at.y - k_cross}, {at.x, at.y + k_cross}}},
          false,
          Stroke{k_black, 0.1}};
}

std::string paper_text(const Paper& paper) {
  const bool is_named = std::find(papers().begin(), papers().end(), paper) != papers().end();
  std::string name = paper.name;
  if (is_named) name[0] = static_cast<char>(name[0] - 'a' + 'A');
  return name;
}

std::string size_text(Vec2 size) {
  return fixed_text(size.x, 1) + " × " + fixed_text(size.y, 1) + " mm";
}

class TiledPdf {
 public:
  /// @param first size of the first page, millimetres
  /// @param pages what the others are called
  TiledPdf(const Drawing& drawing, const TileGrid& grid, Vec2 first, std::string pages)
      : drawing_(drawing),
        grid_(grid),
        first_(first),
        pages_(std::move(pages)),
        used_(used_tiles(drawing, grid_)),
        document_(drawing) {}

  std::string write() {
    PdfContent sheet;
    sheet.add_layers(drawing_.layers);
    document_.add_sheet(sheet.text(), {drawing_.width, drawing_.height});
    add_first_page();
    for (std::size_t row = 0; row < grid_.rows; ++row) {
      for (std::size_t column = 0; column < grid_.columns; ++column) {
        if (is_used(row, column)) add_tile(row, column);
      }
    }
    return document_.bytes();
  }

 private:
  bool is_used(std::size_t row, std::size_t column) const {
    return used_[row * grid_.columns + column];
  }

  void add_first_page();
  std::vector<std::string> notes() const;
  std::vector<std::string> advice() const;
  void add_advice(PdfContent& page) const;
  void add_map(PdfContent& page) const;
  void add_piece_names(PdfContent& page, Vec2 upper_left, double scale) const;
  void add_tile(std::size_t row, std::size_t column);
  void add_neighbours(PdfContent& page, std::size_t row, std::size_t column) const;
  void add_crosses(PdfContent& page, std::size_t row, std::size_t column) const;

  const Drawing& drawing_;
  TileGrid grid_;
  Vec2 first_;
  std::string pages_;
  std::vector<bool> used_;
  PdfDocument document_;
};

void TiledPdf::add_first_page() {
  PdfContent page;
  add_advice(page);
  add_map(page);
  const Vec2 corner = {k_tile_margin, k_tile_margin};
  page.add(rectangle(corner, {50.0, 50.0}, k_black, 0.25));
  page.add(Text{corner + Vec2{3.0, 4.0}, 3.0, "50 mm"});
  const Vec2 second = corner + Vec2{60.0, 0.0};
  page.add(rectangle(second, {2.0 * k_inch, 2.0 * k_inch}, k_black, 0.25));
  page.add(Text{second + Vec2{3.0, 4.0}, 3.0, "2 in"});
  document_.add_page(first_, page.text());
}

/// The drawing's notes, as many in a line as fit.
std::vector<std::string> TiledPdf::notes() const {
  constexpr std::size_t most_letters = 90;
  std::vector<std::string> lines;
  for (const std::string& note : drawing_.notes) {
    if (lines.empty() || lines.back().size() + note.size() > most_letters) {
      lines.push_back(note);
    } else {
      lines.back() += " · " + note;
    }
  }
  return lines;
}

std::vector<std::string> TiledPdf::advice() const {
  std::vector<std::string> lines = notes();
  const auto count = std::count(used_.begin(), used_.end(), true);
  lines.insert(
      lines.end(),
      {size_text(grid_.area) + " on " + std::to_string(count) +
           (count == 1 ? " page of " : " pages of ") + pages_ +
           " besides this one. Crossed out: empty and left out.",
       "Print at 100 % (\"actual size\"), not fitted to the page. Measure the squares before "
       "cutting.",
       "Pages overlap by " + number_text(grid_.overlap) +
           " mm: cut along the frame where it says cut, glue where it says glue, so that crosses "
           "meet.",
       "The map below is not at true size, the squares at the bottom are."});
  return lines;
}

void TiledPdf::add_advice(PdfContent& page) const {
  const double top = first_.y - k_tile_margin;
  page.add(Text{{k_tile_margin, top - 6.0}, 6.0, drawing_.title});
  double y = top - k_title;
  for (const std::string& line : advice()) {
    page.add(Text{{k_tile_margin, y}, 2.8, line});
    y -= k_line;
  }
}

void TiledPdf::add_map(PdfContent& page) const {
  const Vec2 size = grid_.size();
  const double map_top = k_tile_margin + k_title + k_line * static_cast<double>(advice().size());
  const Vec2 room = {first_.x - 2.0 * k_tile_margin,
                     first_.y - map_top - k_map_bottom - k_tile_margin};
  const double scale = std::min({room.x / size.x, room.y / size.y, 1.0});
  // The sheet hangs from the upper left corner of the map.
  const Vec2 top_left = {k_tile_margin, first_.y - map_top};
  const Vec2 upper_left = grid_.low + Vec2{0.0, grid_.area.y};
  const auto on_map = [&](Vec2 p) { return top_left + scale * (p - upper_left); };
  page.add_form(k_sheet, on_map({0.0, 0.0}), scale);
  add_piece_names(page, top_left - scale * upper_left, scale);
  const double largest = drawing_.pieces.size() > 1 ? 3.0 : 8.0;
  const double name_height =
      std::min(largest, 0.2 * scale * std::min(grid_.frame.x, grid_.frame.y));
  for (std::size_t row = 0; row < grid_.rows; ++row) {
    for (std::size_t column = 0; column < grid_.columns; ++column) {
      const Vec2 low = on_map(grid_.low_of(row, column)), frame = scale * grid_.frame;
      page.add(rectangle(low, frame, k_grey, 0.2));
      if (!is_used(row, column)) {
        page.add(Path{{{low, low + frame}, {{low.x, low.y + frame.y}, {low.x + frame.x, low.y}}},
                      false,
                      Stroke{k_grey, 0.2}});
      }
      const Vec2 middle = low + 0.5 * frame;
      // Beside names of pieces it stands in the corner.
      const bool is_corner = drawing_.pieces.size() > 1;
      const Vec2 at = is_corner ? Vec2{low.x + 1.0, low.y + frame.y - 1.0 - name_height}
                                : Vec2{middle.x, middle.y - 0.5 * name_height};
      page.add(Text{at, name_height, tile_name(row, column), k_black, !is_corner});
    }
  }
}

/// Of several pieces, each in the middle of what is cut of it.
void TiledPdf::add_piece_names(PdfContent& page, Vec2 shift, double scale) const {
  constexpr double height = 2.2;
  if (drawing_.pieces.size() < 2) return;
  std::vector<std::vector<Polygon>> lines(drawing_.pieces.size());
  for (const Layer& layer : drawing_.layers) {
    if (layer.name != "cut") continue;
    for (const DrawingShape& shape : layer.shapes) {
      const auto* path = std::get_if<Path>(&shape);
      if (path == nullptr || path->piece >= lines.size()) continue;
      std::vector<Polygon>& own = lines[path->piece];
      own.insert(own.end(), path->lines.begin(), path->lines.end());
    }
  }
  for (std::size_t p = 0; p < lines.size(); ++p) {
    if (lines[p].empty()) continue;
    const LoopBox box = loop_box(lines[p]);
    const Vec2 middle = shift + 0.5 * scale * (box.low + box.high);
    page.add(
        Text{{middle.x, middle.y - 0.5 * height}, height, drawing_.pieces[p].name, k_blue, true});
  }
}

void TiledPdf::add_tile(std::size_t row, std::size_t column) {
  const Vec2 corner = {k_tile_margin, k_tile_margin};
  PdfContent page;
  page.add_form_within(k_sheet, corner - grid_.low_of(row, column), corner, grid_.frame);
  page.add(rectangle(corner, grid_.frame, k_grey, 0.1));
  add_crosses(page, row, column);
  add_neighbours(page, row, column);
  const std::string name = tile_name(row, column);
  const Vec2 inside = {corner.x + grid_.overlap + 2.0,
                       corner.y + grid_.frame.y - grid_.overlap - 8.0};
  page.add(Text{inside, 6.0, name, k_grey});
  page.add(Text{{corner.x, corner.y - k_note_height - 1.5},
                k_note_height,
                name + ": row " + std::to_string(row + 1) + " of " + std::to_string(grid_.rows) +
                    ", column " + std::to_string(column + 1) + " of " +
                    std::to_string(grid_.columns) + ". " + drawing_.title});
  document_.add_page(grid_.page, page.text());
}

// Crosses stand in the middle of the overlap, at the corners and halfway between. So each is on the
// same spot of the sheet on every page that shows it. There are none where no neighbour is.
void TiledPdf::add_crosses(PdfContent& page, std::size_t row, std::size_t column) const {
  const double inset = k_tile_margin + 0.5 * grid_.overlap;
  const Vec2 low = {inset, inset}, high = grid_.page - low, middle = 0.5 * grid_.page;
  const bool left = column > 0, right = column + 1 < grid_.columns;
  const bool above = row > 0, below = row + 1 < grid_.rows;
  const auto add = [&](bool wanted, Vec2 at) {
    if (wanted) page.add(cross_at(at));
  };
  add(left || below, low);
  add(right || below, {high.x, low.y});
  add(left || above, {low.x, high.y});
  add(right || above, high);
  add(left, {low.x, middle.y});
  add(right, {high.x, middle.y});
  add(below, {middle.x, low.y});
  add(above, {middle.x, high.y});
}

// Beside the crosses in the middles of the sides: the page that is joined there.
void TiledPdf::add_neighbours(PdfContent& page, std::size_t row, std::size_t column) const {
  constexpr double height = 2.5, beside = 6.0;
  const double inset = k_tile_margin + 0.5 * grid_.overlap;
  const Vec2 high = grid_.page - Vec2{inset, inset}, middle = 0.5 * grid_.page;
  const auto add = [&](bool wanted, Vec2 at, const std::string& text) {
    if (wanted) page.add(Text{at, height, text, k_grey, true});
  };
  add(column > 0, {inset + 4.0, middle.y + beside}, "cut, " + tile_name(row, column - 1));
  add(column + 1 < grid_.columns, {high.x - 4.0, middle.y + beside},
      "glue " + tile_name(row, column + 1));
  add(row > 0, {middle.x + 3.0 * beside, high.y - 1.0}, "cut, " + tile_name(row - 1, column));
  add(row + 1 < grid_.rows, {middle.x + 3.0 * beside, inset - 1.0},
      "glue " + tile_name(row + 1, column));
}

/// What the first page says need not be on the others, but beside the legend.
Drawing without_label(Drawing drawing) {
  const auto has_shapes = [](const Layer& layer) {
    return layer.name == "legend" && !layer.shapes.empty();
  };
  if (std::any_of(drawing.layers.begin(), drawing.layers.end(), has_shapes)) return drawing;
  for (Layer& layer : drawing.layers) {
    if (layer.name == "label") layer.shapes.clear();
  }
  return drawing;
}

}  // namespace

namespace {

/// The drawing with its label, where all of that fits on one page and is to be one.
std::optional<TileGrid> single_page(const Drawing& drawing, const PageOptions& options) {
  if (!options.one_page) return std::nullopt;
  const TileGrid grid = tile_grid(drawing, options);
  return grid.rows * grid.columns == 1 ? std::optional(grid) : std::nullopt;
}

std::string one_page_pdf(const Drawing& drawing, const TileGrid& grid) {
  PdfContent sheet, page;
  sheet.add_layers(drawing.layers);
  const Vec2 corner = {k_tile_margin, k_tile_margin};
  page.add_form_within(k_sheet, corner - grid.low_of(0, 0), corner, grid.frame);
  PdfDocument document(drawing);
  document.add_sheet(sheet.text(), {drawing.width, drawing.height});
  document.add_page(grid.page, page.text());
  return document.bytes();
}

}  // namespace

std::string format_tiled_pdf(const Drawing& drawing, const PageOptions& options) {
  if (const auto grid = single_page(drawing, options)) return one_page_pdf(drawing, *grid);
  const Drawing pieces = without_label(drawing);
  const TileGrid grid = tile_grid(pieces, options);
  return TiledPdf(pieces, grid, grid.page, paper_text(options.paper)).write();
}

std::size_t count_pages(const Drawing& drawing, const PageOptions& options) {
  if (single_page(drawing, options)) return 1;
  const Drawing pieces = without_label(drawing);
  const std::vector<bool> used = used_tiles(pieces, tile_grid(pieces, options));
  return 1 + static_cast<std::size_t>(std::count(used.begin(), used.end(), true));
}

std::optional<std::string> format_divided_pdf(const Drawing& drawing) {
  constexpr Vec2 a4 = {210.0, 297.0};
  const Drawing pieces = without_label(drawing);
  const std::optional<TileGrid> grid = tile_grid(pieces, k_longest_page);
  if (!grid) return std::nullopt;
  return TiledPdf(pieces, *grid, a4, size_text(grid->page)).write();
}

}  // namespace planish
