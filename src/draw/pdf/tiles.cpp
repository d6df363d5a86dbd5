#include "draw/pdf/tiles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include <planish/core/error.h>
#include <planish/core/range.h>

#include "core/number_text.h"
#include "draw/text/stroke_text.h"

namespace planish {

namespace {

constexpr double k_most_tiles = 10000.0;

double count_along(double length, double frame, double overlap) {
  // A thousandth of a millimetre too much is rounding, no page.
  const double more = (length - frame - 1e-3) / (frame - overlap);
  return 1.0 + std::max(0.0, std::ceil(more));
}

Vec2 frame_of(Vec2 page) {
  return page - 2.0 * Vec2{k_tile_margin, k_tile_margin};
}

void check_count(double tiles) {
  if (tiles <= k_most_tiles) return;
  throw Error(ErrorCode::too_large,
              "the pattern would take more than 10,000 pages: check its unit, or take larger "
              "paper");
}

/// The least page that divides a length into as few as pages of the longest do.
double page_along(double length, double longest, double overlap) {
  const double margins = 2.0 * k_tile_margin;
  const double count = count_along(length, longest - margins, overlap);
  return std::ceil((length - overlap) / count + overlap - 1e-3) + margins;
}

double count_on(Vec2 sheet, Vec2 page, double overlap) {
  const Vec2 frame = frame_of(page);
  return count_along(sheet.x, frame.x, overlap) * count_along(sheet.y, frame.y, overlap);
}

TileGrid grid_on(Vec2 sheet, Vec2 page, double overlap) {
  const Vec2 frame = frame_of(page);
  check_count(count_on(sheet, page, overlap));
  return {.page = page,
          .frame = frame,
          .columns = static_cast<std::size_t>(count_along(sheet.x, frame.x, overlap)),
          .rows = static_cast<std::size_t>(count_along(sheet.y, frame.y, overlap)),
          .area = sheet,
          .overlap = overlap};
}

/// The paper upright and across.
/// @throws Error option_out_of_range
std::array<Vec2, 2> pages_of(const PageOptions& options) {
  const Paper& paper = options.paper;
  check_range("page_overlap", options.overlap, {.min = 0.0});
  const double least = 2.0 * k_tile_margin + options.overlap,
               shorter = std::min(paper.width, paper.height);
  if (!(shorter > least)) {
    throw Error(ErrorCode::option_out_of_range,
                "paper " + paper.name + " is " + fixed_text(shorter, 1) +
                    " mm wide, but margins and overlap alone take " + fixed_text(least, 1) +
                    " mm: take larger paper or less overlap");
  }
  return {{{paper.width, paper.height}, {paper.height, paper.width}}};
}

// The box around all that shows.
struct Box {
  static constexpr double k_far = std::numeric_limits<double>::infinity();
  Vec2 low = {k_far, k_far}, high = {-k_far, -k_far};

  bool is_empty() const { return !(low.x <= high.x); }

  void add(const Path& path) {
    if (!path.stroke && !path.fill) return;
    for (const auto& line : path.lines) {
      for (const Vec2 p : line) {
        if (!std::isfinite(p.x) || !std::isfinite(p.y)) continue;
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
      }
    }
  }
  void add(const Text& text) { add(Path{.lines = text_strokes(text), .stroke = Stroke{}}); }
};

/// What tiles show: all that is drawn, with a little around it; the sheet where that is nothing.
Box shown_of(const Drawing& drawing) {
  constexpr double margin = 2.0;
  Box box;
  for (const Layer& layer : drawing.layers) {
    for (const DrawingShape& shape : layer.shapes)
      std::visit([&](const auto& some) { box.add(some); }, shape);
  }
  if (box.is_empty()) return {{}, {drawing.width, drawing.height}};
  const Vec2 around = {margin, margin};
  return {box.low - around, box.high + around};
}

// Which tiles something is on.
class Marks {
 public:
  explicit Marks(const TileGrid& grid) : grid_(grid), used_(grid.columns * grid.rows, false) {}

  void add(const Path& path) {
    if (!path.stroke && !path.fill) return;
    for (const auto& line : path.lines)
      add_line(line, path.closed);
    if (path.closed || path.fill) add_inside(path);
  }
  void add(const Text& text) { add(Path{.lines = text_strokes(text), .stroke = Stroke{}}); }

  /// Its lines are closed for that.
  void add_inside(const Path& path);

  std::vector<bool> take() && { return std::move(used_); }

 private:
  void add_line(std::span<const Vec2> line, bool closed);
  void add_segment(Vec2 a, Vec2 b);
  std::vector<double> crossings(const Path& path, double y) const;

  const TileGrid& grid_;
  std::vector<bool> used_;
};

void Marks::add_line(std::span<const Vec2> line, bool closed) {
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (i + 1 == line.size() && !closed && i > 0) break;
    add_segment(line[i], line[(i + 1) % line.size()]);
  }
}

// Whether a segment meets a rectangle: the part of it inside the sides so far grows shorter.
bool meets(Vec2 a, Vec2 b, Vec2 low, Vec2 high) {
  double from = 0.0, to = 1.0;
  const auto clip = [&](double start, double end, double least, double most) {
    const double way = end - start;
    if (way == 0.0) return start >= least && start <= most;
    const double first = (least - start) / way, last = (most - start) / way;
    from = std::max(from, std::min(first, last));
    to = std::min(to, std::max(first, last));
    return from <= to;
  };
  return clip(a.x, b.x, low.x, high.x) && clip(a.y, b.y, low.y, high.y);
}

// The tiles 0 to count - 1 whose place along an axis may hold [low, high].
struct TileSpan {
  std::size_t from, to;  // without `to`
};

TileSpan tiles_between(double low, double high, double step, double frame, std::size_t count) {
  const auto most = static_cast<double>(count);
  const double from = std::clamp(std::floor((low - frame) / step), 0.0, most);
  const double to = std::clamp(std::floor(high / step) + 1.0, 0.0, most);
  return {static_cast<std::size_t>(from), static_cast<std::size_t>(to)};
}

void Marks::add_segment(Vec2 a, Vec2 b) {
  if (!std::isfinite(a.x + a.y) || !std::isfinite(b.x + b.y)) return;
  const Vec2 step = grid_.step(), frame = grid_.frame;
  const double top = grid_.area.y;
  a = a - grid_.low;
  b = b - grid_.low;
  const TileSpan columns =
      tiles_between(std::min(a.x, b.x), std::max(a.x, b.x), step.x, frame.x, grid_.columns);
  const TileSpan rows = tiles_between(top - std::max(a.y, b.y), top - std::min(a.y, b.y), step.y,
                                      frame.y, grid_.rows);
  for (std::size_t row = rows.from; row < rows.to; ++row) {
    for (std::size_t column = columns.from; column < columns.to; ++column) {
      const Vec2 low = grid_.low_of(row, column) - grid_.low;
      if (meets(a, b, low, low + frame)) used_[row * grid_.columns + column] = true;
    }
  }
}

std::vector<double> Marks::crossings(const Path& path, double y) const {
  std::vector<double> places;
  for (const auto& line : path.lines) {
    for (std::size_t i = 0; i < line.size(); ++i) {
      const Vec2 a = line[i], b = line[(i + 1) % line.size()];
      if ((a.y > y) != (b.y > y)) places.push_back(a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x));
    }
  }
  std::sort(places.begin(), places.end());
  return places;
}

// Tiles that no line meets are inside or outside as a whole: their middles show which.
void Marks::add_inside(const Path& path) {
  for (std::size_t row = 0; row < grid_.rows; ++row) {
    const double y = grid_.low_of(row, 0).y + 0.5 * grid_.frame.y;
    const std::vector<double> places = crossings(path, y);
    for (std::size_t column = 0; !places.empty() && column < grid_.columns; ++column) {
      const double x = grid_.low_of(row, column).x + 0.5 * grid_.frame.x;
      const auto behind = std::upper_bound(places.begin(), places.end(), x);
      if ((behind - places.begin()) % 2 == 1) used_[row * grid_.columns + column] = true;
    }
  }
}

}  // namespace

const std::vector<Paper>& papers() {
  static const std::vector<Paper> all = {
      {"a4", 210.0, 297.0},      {"a3", 297.0, 420.0},     {"a2", 420.0, 594.0},
      {"a1", 594.0, 841.0},      {"a0", 841.0, 1189.0},    {"b4", 250.0, 353.0},
      {"b3", 353.0, 500.0},      {"b2", 500.0, 707.0},     {"b1", 707.0, 1000.0},
      {"b0", 1000.0, 1414.0},    {"letter", 215.9, 279.4}, {"legal", 215.9, 355.6},
      {"tabloid", 279.4, 431.8},
  };
  return all;
}

Paper paper_named(std::string_view name) {
  std::string known;
  for (const Paper& paper : papers()) {
    if (paper.name == name) return paper;
    known += (known.empty() ? "" : ", ") + paper.name;
  }
  throw Error(ErrorCode::unknown_name,
              "no paper is called '" + std::string(name) + "'; there are " + known);
}

Vec2 TileGrid::low_of(std::size_t row, std::size_t column) const {
  return low + Vec2{static_cast<double>(column) * step().x,
                    area.y - static_cast<double>(row) * step().y - frame.y};
}

Vec2 TileGrid::size() const {
  return {static_cast<double>(columns) * step().x + overlap,
          static_cast<double>(rows) * step().y + overlap};
}

void check_page_area(double area, const PageOptions& options) {
  const Vec2 frame = frame_of(pages_of(options).front());
  check_count(area / (frame.x * frame.y));
}

std::string tile_name(std::size_t row, std::size_t column) {
  std::string letters;
  for (std::size_t rest = row + 1; rest > 0; rest = (rest - 1) / 26)
    letters.insert(letters.begin(), static_cast<char>('A' + (rest - 1) % 26));
  return letters + std::to_string(column + 1);
}

TileGrid tile_grid(Vec2 area, const PageOptions& options) {
  const auto [upright, across] = pages_of(options);
  const bool is_across =
      count_on(area, across, options.overlap) < count_on(area, upright, options.overlap);
  return grid_on(area, is_across ? across : upright, options.overlap);
}

TileGrid tile_grid(const Drawing& drawing, const PageOptions& options) {
  const Box box = shown_of(drawing);
  const Vec2 area = box.high - box.low;
  TileGrid best = tile_grid(area, options);
  best.low = box.low;
  const auto used = [&](const TileGrid& grid) {
    const std::vector<bool> tiles = used_tiles(drawing, grid);
    return std::count(tiles.begin(), tiles.end(), true);
  };
  for (const Vec2 page : pages_of(options)) {
    if (page == best.page || count_on(area, page, options.overlap) > k_most_tiles) continue;
    TileGrid other = grid_on(area, page, options.overlap);
    other.low = box.low;
    if (used(other) < used(best)) best = other;
  }
  return best;
}

PageRoom page_room(const PageOptions& options, bool across) {
  const Vec2 frame = frame_of(pages_of(options)[across ? 1 : 0]);
  return {frame, frame - Vec2{options.overlap, options.overlap}};
}

std::optional<TileGrid> tile_grid(const Drawing& drawing, double longest) {
  const Box box = shown_of(drawing);
  const Vec2 area = box.high - box.low;
  const double frame = longest - 2.0 * k_tile_margin;
  constexpr double overlap = 10.0;
  if (!(count_along(area.x, frame, overlap) * count_along(area.y, frame, overlap) <= k_most_tiles))
    return std::nullopt;
  const Vec2 page = {page_along(area.x, longest, overlap), page_along(area.y, longest, overlap)};
  TileGrid grid = grid_on(area, page, overlap);
  grid.low = box.low;
  return grid;
}

namespace {

bool has_fold(const Drawing& drawing) {
  const auto is_fold = [](const DrawingShape& shape) {
    const auto* path = std::get_if<Path>(&shape);
    const auto* fold = path != nullptr ? std::get_if<FoldMark>(&path->mark) : nullptr;
    return fold != nullptr && !fold->opened;
  };
  return std::any_of(drawing.layers.begin(), drawing.layers.end(), [&](const Layer& layer) {
    return std::any_of(layer.shapes.begin(), layer.shapes.end(), is_fold);
  });
}

}  // namespace

std::vector<bool> used_tiles(const Drawing& drawing, const TileGrid& grid) {
  Marks marks(grid);
  // A cut line bounds its piece also where it is open along a fold.
  const bool folded = has_fold(drawing);
  for (const Layer& layer : drawing.layers) {
    for (const DrawingShape& shape : layer.shapes) {
      std::visit([&](const auto& some) { marks.add(some); }, shape);
      const auto* path = std::get_if<Path>(&shape);
      if (path != nullptr && layer.name == "cut" && folded) marks.add_inside(*path);
    }
  }
  return std::move(marks).take();
}

}  // namespace planish
