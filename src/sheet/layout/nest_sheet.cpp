#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <utility>
#include <variant>

#include <planish/core/error.h>
#include <planish/sheet/nest_sheet.h>

#include "core/figure_text.h"
#include "core/math.h"
#include "draw/text/text_lines.h"
#include "pattern/polygon/loop_box.h"
#include "sheet/annotations.h"
#include "sheet/layout/laid_pieces.h"
#include "sheet/piece/placed_pattern.h"
#include "sheet/piece/sheet_length.h"
#include "sheet/sheet_layout.h"

namespace planish {

namespace {

constexpr double k_least_width = 240.0;  // of a drawing, for the words above the sheet, millimetres
constexpr std::size_t k_line_words = 80;  // letters that fit there

PatternGeometry pattern_of(const NestJob& job, const NestPatch& patch) {
  return placed_pattern(patch.mesh, patch.pattern, job.unit, patch.name, patch.annotations);
}

int copies_of(const NestPatch& patch) {
  return std::max(1, patch.annotations.label.quantity);
}

/// Which of several copies it is, for people; nothing for a single one.
std::string copy_text(const NestPatch& patch, int copy) {
  const int copies = copies_of(patch);
  if (copies == 1) return {};
  return " " + std::to_string(copy + 1) + " of " + std::to_string(copies);
}

/// What a copy gets where it lies: its own name, and the grain turned as it is.
PatternOptions annotations_there(const NestJob& job, const NestPlacement& placement) {
  const NestPatch& patch = job.patches[placement.piece];
  PatternOptions annotations = patch.annotations;
  PieceLabel& label = annotations.label;
  if (label.name.empty()) label.name = patch.name;
  label.name += copy_text(patch, placement.copy);
  label.quantity = 0;
  if (annotations.grain) {
    if (auto* degrees = std::get_if<double>(&*annotations.grain)) *degrees += placement.angle;
  }
  return annotations;
}

Path box_line(Vec2 low, Vec2 size) {
  return {{{low, {low.x + size.x, low.y}, low + size, {low.x, low.y + size.y}}},
          true,
          Stroke{sheet::k_label_color}};
}

std::string use_text(const NestJob& job, const Nesting& nesting) {
  const NestOptions& sheets = job.sheets;
  const Unit unit = job.patches.empty() ? Unit::mm : job.patches.front().annotations.sheet_unit;
  const std::string used = sheet_length(nesting.used_length, unit, 1);
  const std::string share = decimals_text(100.0 * nesting.used_share(), 1) + " % in pieces";
  const std::string width = sheet_length(sheets.width, unit, 1);
  if (sheets.folded)
    return "folded cloth, " + width + " wide as it lies, " + used + " used, " + share;
  if (!sheets.length) return "roll of width " + width + ", " + used + " used, " + share;
  return "sheets " + width + " wide and " + sheet_length(*sheets.length, unit, 1) +
         " long, of the last " + used + " used, " + share;
}

/// Above the sheet, so that its corner stays the origin.
Layer nest_label(const NestJob& job, const Nesting& nesting, std::size_t number,
                 const std::string& title, Vec2 size, const std::string& lines) {
  const std::string date = job.patches.empty() ? "" : job.patches.front().annotations.date;
  Layer layer{"label", {box_line({0.0, 0.0}, size)}};
  const double low = size.y + sheet::k_gap, top = low + sheet::k_square;
  const auto line = [&](double below_top, double height, std::string text) {
    constexpr double left = sheet::k_square + sheet::k_gap, smallest = 2.0;
    constexpr double room = k_least_width - left - sheet::k_margin;
    const double letters = std::max(1.0, static_cast<double>(letters_in(text)));
    const double fitting = std::max(smallest, room / (sheet::k_letter_width * letters));
    layer.shapes.emplace_back(Text{
        {left, top - below_top}, std::min(height, fitting), std::move(text), sheet::k_label_color});
  };
  layer.shapes.emplace_back(box_line({0.0, low}, {sheet::k_square, sheet::k_square}));
  line(6.0, 6.0, title);
  line(sheet::k_square, 2.2, "the square is 50 mm – measure it before cutting");
  if (job.sheets.length) {
    line(13.0, 4.0,
         "sheet " + std::to_string(number + 1) + " of " + std::to_string(nesting.sheets));
  }
  line(20.0, 4.0, use_text(job, nesting));
  double below = 27.0;
  for (std::string& words : broken_lines(lines, k_line_words)) {
    line(below, 2.5, std::move(words));
    below += 4.0;
  }
  if (!date.empty()) line(std::max(below, 32.0), 2.5, date);
  return layer;
}

NestPatch mirror_image(NestPatch patch) {
  for (Triangle& t : patch.mesh.triangles)
    std::swap(t[1], t[2]);
  for (Vec2& p : patch.pattern)
    p.x = 0.0 - p.x;
  PatternOptions own = on_mirrored_border(for_mirror_image(std::move(patch.annotations)));
  own.like.reset();
  own.label.quantity = own.label.mirrored;
  own.label.mirrored = 0;
  if (!own.label.name.empty()) own.label.name += ", mirrored";
  patch.name += ", mirrored";
  patch.annotations = std::move(own);
  return patch;
}

std::vector<Layer> empty_piece_layers() {
  std::vector<Layer> layers;
  for (const char* name :
       {"seam", "notch", "grain", "fold", "drill", "internal", "annotation", "hole", "cut"})
    layers.push_back({name, {}});
  return layers;
}

void add_shapes(Layer layer, std::size_t piece, Layer& to) {
  for (DrawingShape& shape : layer.shapes) {
    std::visit([&](auto& some) { some.piece = piece; }, shape);
    to.shapes.push_back(std::move(shape));
  }
}

}  // namespace

std::vector<NestPatch> with_mirror_images(std::vector<NestPatch> patches) {
  std::vector<NestPatch> result;
  result.reserve(patches.size());
  for (NestPatch& patch : patches) {
    const PieceLabel label = patch.annotations.label;
    const int mirrored = std::min(label.mirrored, std::max(1, label.quantity));
    const int as_drawn = std::max(1, label.quantity) - mirrored;
    if (mirrored == 0) {
      result.push_back(std::move(patch));
      continue;
    }
    NestPatch image = mirror_image(patch);
    image.annotations.label.quantity = mirrored;
    patch.annotations.label.quantity = as_drawn;
    patch.annotations.label.mirrored = 0;
    if (as_drawn > 0) result.push_back(std::move(patch));
    result.push_back(std::move(image));
  }
  return result;
}

PatternGeometry pattern_geometry(const NestPatch& patch, Unit unit) {
  PatternGeometry pattern =
      placed_pattern(patch.mesh, patch.pattern, unit, patch.name, patch.annotations);
  pattern.filled = filled_stretches(pattern);
  return annotated(std::move(pattern), patch.mesh);
}

namespace {

double degrees_to_x(Vec2 direction) {
  return -180.0 / std::numbers::pi * math::atan2(direction.y, direction.x);
}

/// The turn that lays the fold of a half along the sheet.
/// @param angle that lays its grain so, where it has one
double fold_angle(const PatternGeometry& pattern, std::optional<double> angle) {
  constexpr double k_most = 5.0;  // degrees between the grain and the fold
  const EdgeAllowance stretch = fold_stretch(pattern.outline, *pattern.options.fold);
  const double own = degrees_to_x(pattern.positions[stretch.to] - pattern.positions[stretch.from]);
  if (!angle) return own;
  const double between = std::abs(std::remainder(own - *angle, 180.0));
  if (between <= k_most) return own;
  throw Error(ErrorCode::misplaced_allowance,
              "piece \"" + pattern.name + "\": its grain and its fold are " +
                  decimals_text(between, 1) +
                  " degrees apart, but on folded cloth both lie along its length; lay it on cloth "
                  "that is not folded, or give another grain");
}

}  // namespace

std::vector<NestPiece> nest_pieces(const NestJob& job) {
  std::vector<NestPiece> result;
  result.reserve(job.patches.size());
  for (const NestPatch& patch : job.patches) {
    NestPiece& some = result.emplace_back();
    some.outline.piece = patch.name;
    some.turns = patch.turns;
    some.quantity = patch.pattern.empty() ? 0 : copies_of(patch);
    if (patch.pattern.empty()) continue;
    PatternGeometry pattern = pattern_of(job, patch);
    std::optional<double> along_grain;
    if (patch.annotations.grain)
      along_grain = degrees_to_x(grain_on_sheet(*patch.annotations.grain, patch.mesh, pattern));
    some.angle = along_grain.value_or(0.0);
    if (job.sheets.folded && patch.annotations.is_half())
      some.fold = fold_angle(pattern, along_grain);
    some.outline.loops = std::move(pattern.cut);
  }
  return result;
}

Drawing nest_sheet(const NestJob& job, const Nesting& nesting, std::size_t number,
                   const std::string& title) {
  const Vec2 size = {job.sheets.length.value_or(nesting.used_length), job.sheets.width};
  Drawing sheet = laid_pieces(job, nesting, number);
  sheet.title = title;
  sheet.width = std::max(size.x, k_least_width);
  sheet.height = size.y + sheet::k_gap + sheet::k_square + sheet::k_margin;
  add_below_cut(sheet, nest_label(job, nesting, number, title, size, line_words(sheet.layers)));
  sheet.notes = {use_text(job, nesting)};
  return sheet;
}

void add_below_cut(Drawing& sheet, Layer layer) {
  sheet.layers.insert(sheet.layers.end() - 1, std::move(layer));
}

Drawing laid_pieces(const NestJob& job, const Nesting& nesting, std::size_t number) {
  Drawing sheet{"", 0.0, 0.0, empty_piece_layers()};
  std::optional<std::pair<std::size_t, PatternGeometry>> last;  // copies of a piece come together
  for (const NestPlacement& placement : nesting.placements) {
    if (placement.sheet != number) continue;
    const NestPatch& patch = job.patches[placement.piece];
    if (!last || last->first != placement.piece) {
      last = {placement.piece, pattern_of(job, patch)};
    }
    PatternGeometry pattern = moved(last->second, placement);
    pattern.options = annotations_there(job, placement);
    const PieceLabel label = pattern.options.label;
    std::vector<Layer> layers = piece_layers(annotated(std::move(pattern), patch.mesh));
    for (std::size_t k = 0; k < layers.size(); ++k)
      add_shapes(std::move(layers[k]), sheet.pieces.size(), sheet.layers[k]);
    sheet.pieces.push_back({label.name, label.size, 1});
  }
  return sheet;
}

Drawing pieces_sheet(const NestJob& job, std::span<const std::optional<PatchTwin>> twins,
                     const std::string& title) {
  constexpr double gap = 20.0;
  Drawing sheet{title, 0.0, 0.0, empty_piece_layers()};
  std::vector<std::size_t> number(job.patches.size());  // of its piece on the sheet
  Vec2 corner;
  for (std::size_t p = 0; p < job.patches.size(); ++p) {
    const NestPatch& patch = job.patches[p];
    if (patch.pattern.empty()) continue;
    const PieceLabel& label = patch.annotations.label;
    const int copies = copies_of(patch), mirrored = std::min(label.mirrored, copies);
    const auto& twin = twins[p];
    if (twin && !job.patches[twin->patch].pattern.empty()) {
      number[p] = number[twin->patch];
      DrawingPiece& other = sheet.pieces[number[p]];
      other.quantity += twin->mirrored ? mirrored : copies - mirrored;
      other.mirrored += twin->mirrored ? copies - mirrored : mirrored;
      continue;
    }
    number[p] = sheet.pieces.size();
    PatternGeometry pattern = pattern_of(job, patch);
    const LoopBox box = loop_box(pattern.cut);
    const Vec2 shift = corner - box.low;
    corner.x += box.size().x + gap;
    sheet.width = corner.x;
    sheet.height = std::max(sheet.height, box.size().y);
    pattern = moved(std::move(pattern), [&](Vec2 at) { return at + shift; });
    std::vector<Layer> layers = piece_layers(annotated(std::move(pattern), patch.mesh));
    for (std::size_t k = 0; k < layers.size(); ++k)
      add_shapes(std::move(layers[k]), number[p], sheet.layers[k]);
    sheet.pieces.push_back({label.name.empty() ? patch.name : label.name, label.size,
                            copies - mirrored, mirrored, label.fabric, label.note});
    sheet.date = patch.annotations.date;
  }
  return sheet;
}

}  // namespace planish
