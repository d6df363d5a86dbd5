#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <planish/mesh/patch.h>
#include <planish/sheet/product_sheet.h>

#include "flatten/twin_report.h"
#include "pattern/polygon/loop_box.h"
#include "sheet/mirrored_place.h"
#include "sheet/sheet_layout.h"

namespace planish {

namespace {

// Everything in millimetres.
constexpr double k_piece_gap = 15.0;
constexpr double k_piece_name_height = 5.0, k_seam_number_height = 5.0;
constexpr std::array<Color, 6> k_seam_colors = {
    {{0, 90, 181}, {0, 133, 66}, {170, 68, 0}, {120, 60, 160}, {0, 130, 140}, {150, 110, 0}}};

/// Where each piece lies on the sheet.
struct Layout {
  std::vector<std::vector<Vec2>> corners;  ///< of each piece; none where it has no pattern
  std::vector<Vec2> name_at;               ///< of each piece
  double width = 2.0 * sheet::k_margin, height = 2.0 * sheet::k_margin;
};

/// Rows from the top of the sheet down, as wide as makes it about square.
Layout lay_out(std::span<const ProductPiece> pieces, double scale) {
  Layout layout;
  layout.corners.resize(pieces.size());
  layout.name_at.resize(pieces.size());
  std::vector<std::size_t> order;
  std::vector<Vec2> sizes(pieces.size());
  order.reserve(pieces.size());
  double area = 0.0, widest = 0.0;
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    if (pieces[p].pattern.empty()) continue;
    order.push_back(p);
    const LoopBox box = box_around(pieces[p].pattern);
    sizes[p] = scale * box.size() + Vec2{k_piece_gap, k_piece_gap + k_piece_name_height};
    area += sizes[p].x * sizes[p].y;
    widest = std::max(widest, sizes[p].x);
  }
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return sizes[a].y > sizes[b].y; });
  const double row_width = std::max(widest, 1.3 * std::sqrt(area));
  double x = 0.0, top = 0.0, row_height = 0.0;
  for (const std::size_t p : order) {
    if (x > 0.0 && x + sizes[p].x > row_width) {
      top -= row_height;
      x = row_height = 0.0;
    }
    row_height = std::max(row_height, sizes[p].y);
    const Vec2 low = {x, top - sizes[p].y + k_piece_gap};
    const LoopBox box = box_around(pieces[p].pattern);
    layout.corners[p].reserve(pieces[p].pattern.size());
    for (const Vec2 q : pieces[p].pattern)
      layout.corners[p].push_back(low + scale * (q - box.low));
    layout.name_at[p] = {x, top - k_piece_name_height};
    x += sizes[p].x;
    layout.width = std::max(layout.width, x + 2.0 * sheet::k_margin);
  }
  layout.height += row_height - top;
  const Vec2 shift = {sheet::k_margin, layout.height - sheet::k_margin};
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    layout.name_at[p] = layout.name_at[p] + shift;
    for (Vec2& q : layout.corners[p])
      q = q + shift;
  }
  return layout;
}

/// Lays a piece anew at about the same place, from where its twin lies: see mirrored_place().
void lay_like_twin(const PatchTwin& twin, std::size_t piece, Layout& layout) {
  const std::vector<Vec2>& theirs = layout.corners[twin.patch];
  std::vector<Vec2>& own = layout.corners[piece];
  if (theirs.empty() || own.empty()) return;
  const LoopBox there = box_around(theirs), here = box_around(own);
  const double up = std::round(here.low.y - there.low.y);
  const double along = std::ceil(here.low.x + there.high.x),
               right = std::ceil(here.low.x - there.low.x);
  for (std::size_t v = 0; v < theirs.size(); ++v) {
    const double x = twin.mirrored ? mirrored_place(along, theirs[v].x) : theirs[v].x + right;
    own[twin.vertex[v]] = {x, theirs[v].y + up};
  }
}

std::string name_of(std::span<const ProductPiece> pieces, std::size_t number) {
  const auto& twin = pieces[number].twin;
  const std::string& name = pieces[number].name;
  return twin ? name + " (" + twin_text({pieces[twin->patch].name, twin->mirrored}) + ")" : name;
}

}  // namespace

Drawing product_sheet(std::span<const ProductPiece> pieces, std::span<const Seam> seams, Unit unit,
                      const std::string& title) {
  Layout layout = lay_out(pieces, millimetres_per(unit));
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    if (pieces[p].twin) lay_like_twin(*pieces[p].twin, p, layout);
  }
  Layer cut{"cut", {}}, seam_lines{"seam", {}}, label{"label", {}};
  Drawing sheet{title, layout.width, layout.height, {}};
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    sheet.pieces.push_back({pieces[p].name});
    if (pieces[p].pattern.empty()) continue;
    Path border{{}, true, Stroke{sheet::k_cut_color}};
    border.piece = p;
    const Patch patch(pieces[p].mesh);
    for (const std::vector<Index>& loop : patch.border_loops())
      border.lines.push_back(line_of({p, loop}, layout.corners[p]));
    cut.shapes.emplace_back(std::move(border));
    Text name{layout.name_at[p], k_piece_name_height, name_of(pieces, p), sheet::k_label_color};
    name.piece = p;
    label.shapes.emplace_back(std::move(name));
  }
  for (std::size_t s = 0; s < seams.size(); ++s) {
    const Color color = k_seam_colors[s % k_seam_colors.size()];
    for (const SeamSide& side : seams[s].sides) {
      if (pieces[side.patch].pattern.empty()) continue;
      const std::vector<Vec2> along = line_of(side, layout.corners[side.patch]);
      Path line{{along}, false, Stroke{color, 0.8}};
      line.piece = side.patch;
      seam_lines.shapes.emplace_back(std::move(line));
      Text number{along[along.size() / 2], k_seam_number_height, std::to_string(s + 1), color,
                  true};
      number.piece = side.patch;
      seam_lines.shapes.emplace_back(std::move(number));
    }
  }
  sheet.layers = {std::move(seam_lines), std::move(label), std::move(cut)};
  return sheet;
}

}  // namespace planish
