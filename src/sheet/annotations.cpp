#include "sheet/annotations.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <numbers>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "core/math.h"
#include "pattern/polygon/free_strip.h"
#include "pattern/polygon/polygon_rays.h"
#include "sheet/edge_texts.h"
#include "sheet/piece/line_path.h"
#include "sheet/piece/outline_paths.h"
#include "sheet/sheet_layout.h"

namespace planish {

namespace {

// line_words() names these colours.
constexpr Stroke k_cut{sheet::k_cut_color}, k_hole{sheet::k_hole_color},
    k_seam{sheet::k_seam_color, 0.25, true}, k_notch{sheet::k_notch_color},
    k_grain{sheet::k_grain_color}, k_drill{sheet::k_drill_color},
    k_internal{sheet::k_internal_color}, k_fold{sheet::k_fold_color, 0.35, true};
constexpr double k_line_pitch = 1.6;  // of a label's lines, over their height

Layer layer_of(std::string name, std::vector<Polygon> lines, const Stroke& stroke) {
  Layer layer{std::move(name), {}};
  layer.shapes.reserve(lines.size());
  for (Polygon& line : lines)
    layer.shapes.emplace_back(line_path(std::move(line), stroke));
  return layer;
}

Layer outline_layer(std::string name, std::vector<Path> paths) {
  Layer layer{std::move(name), {}};
  for (Path& path : paths)
    layer.shapes.emplace_back(std::move(path));
  return layer;
}

double degrees_of(Vec2 direction) {
  return 180.0 / std::numbers::pi * math::atan2(direction.y, direction.x);
}

Layer notch_layer(const PatternGeometry& pattern) {
  Layer layer{"notch", {}};
  for (const PlacedNotch& notch : pattern.notches) {
    Path path{notch.strokes, false, k_notch};
    // What formats have for notches is on the line that is cut.
    if (!notch.on_seam)
      path.mark =
          NotchMark{notch.at, degrees_of(notch.inward), notch.depth, notch.width, notch.kind};
    layer.shapes.emplace_back(std::move(path));
  }
  return layer;
}

Layer grain_layer(const std::vector<Polygon>& lines) {
  Layer layer{"grain", {}};
  if (lines.empty()) return layer;
  Path path{lines, false, k_grain};
  path.mark = GrainMark{lines.front().front(), lines.front().back()};
  layer.shapes.emplace_back(std::move(path));
  return layer;
}

/// Beside the fold of a half: a line inside the piece whose ends turn to the fold as arrows. Empty
/// where there is no room.
std::vector<Polygon> fold_bracket(const PatternGeometry& pattern) {
  constexpr double k_least = 40.0, k_share = 0.15, k_inset = 10.0, k_head = 4.0, k_half_head = 1.5;
  if (pattern.fold.empty() || pattern.options.fold->opened) return {};
  const Vec2 way = pattern.fold.back() - pattern.fold.front();
  const double length = norm(way);
  if (length < k_least) return {};
  const Vec2 along = 1.0 / length * way, left = {-along.y, along.x};
  const Vec2 from = pattern.fold.front() + k_share * way, to = pattern.fold.back() - k_share * way;
  const auto room_on = [&](Vec2 in) {
    const auto& loops = pattern.outline.loops;
    return is_within(loops, from + k_inset * in) && is_within(loops, to + k_inset * in) &&
           is_within(loops, 0.5 * (from + to) + k_inset * in);
  };
  const Vec2 in = room_on(left) ? left : -1.0 * left;
  if (!room_on(in)) return {};
  std::vector<Polygon> lines = {{from, from + k_inset * in, to + k_inset * in, to}};
  for (const Vec2 tip : {from, to}) {
    const Vec2 base = tip + k_head * in;
    lines.push_back({base - k_half_head * along, tip, base + k_half_head * along});
  }
  return lines;
}

Layer fold_layer(const PatternGeometry& pattern) {
  Layer layer{"fold", {}};
  if (pattern.fold.empty()) return layer;
  Path path{{pattern.fold}, false, k_fold};
  path.mark = FoldMark{pattern.fold.front(), pattern.fold.back(), pattern.options.fold->opened};
  layer.shapes.emplace_back(std::move(path));
  std::vector<Polygon> bracket = fold_bracket(pattern);
  if (bracket.empty()) return layer;
  Path sign{std::move(bracket), false, Stroke{sheet::k_fold_color, 0.35}};
  sign.mark = SignMark{};
  layer.shapes.emplace_back(std::move(sign));
  return layer;
}

Layer drill_layer(const PatternGeometry& pattern) {
  Layer layer{"drill", {}};
  for (const Mark& mark : pattern.options.marks) {
    std::vector<Polygon> lines = mark_lines(pattern.positions, {&mark, 1}, pattern.outline.piece);
    Path path = lines.size() == 1 ? line_path(std::move(lines.front()), k_drill)
                                  : Path{std::move(lines), false, k_drill};
    path.mark = DrillMark{place_of(mark, pattern.positions)};
    layer.shapes.emplace_back(std::move(path));
  }
  return layer;
}

std::string quantity_text(const PieceLabel& label) {
  if (label.quantity <= 0) return {};
  const std::string mirrored =
      label.mirrored > 0 ? ", " + std::to_string(label.mirrored) + " mirrored" : "";
  return std::to_string(label.quantity) + " ×" + mirrored;
}

std::vector<std::string> lines_of(const PieceLabel& label, bool on_fold) {
  std::vector<std::string> lines;
  const auto add = [&](const std::string& before, const std::string& text) {
    if (!text.empty()) lines.push_back(before + text);
  };
  add("", label.name);
  add("size ", label.size);
  add("cut ", quantity_text(label));
  add("", label.fabric);
  add("", on_fold ? "on the fold" : "");
  add("", label.note);
  return lines;
}

/// Of the longest line, in heights of a capital.
double width_of(const std::vector<std::string>& lines) {
  double widest = 0.0;
  for (const std::string& line : lines)
    widest = std::max(widest, text_width(line));
  return widest;
}

/// A label's place and the height of its letters.
struct LabelPlace {
  Vec2 middle;
  double height = 0.0;
};

/// An open line as a closed one that encloses nothing.
Polygon there_and_back(Polygon line) {
  for (std::size_t i = line.size(); i-- > 1;)
    line.push_back(line[i - 1]);
  return line;
}

/// By vertices, and drawn.
std::vector<Polygon> all_inner_lines(const PatternGeometry& pattern) {
  const PatternOptions& options = pattern.options;
  std::vector<Polygon> lines =
      inner_lines(pattern.positions, options.inner_lines, pattern.outline.piece);
  for (Polygon& line : inner_lines(pattern.positions, options.drawn_lines, pattern.outline.piece))
    lines.push_back(std::move(line));
  return lines;
}

/// The outline, and what words and the grain line keep clear of: marks, notches, inner lines and a
/// fold inside.
std::vector<Polygon> free_loops(const PatternGeometry& pattern) {
  constexpr double half = 0.5 * k_cross_size + 1.0;
  std::vector<Polygon> loops = pattern.outline.loops;
  for (const Vec2 at : pattern.marks) {
    loops.push_back({at + Vec2{-half, -half}, at + Vec2{half, -half}, at + Vec2{half, half},
                     at + Vec2{-half, half}});
  }
  for (const Polygon& line : pattern.inner_lines)
    loops.push_back(there_and_back(line));
  if (pattern.options.fold && pattern.options.fold->opened) loops.push_back(pattern.fold);
  for (const Polygon& line : fold_bracket(pattern))
    loops.push_back(there_and_back(line));
  for (const PlacedNotch& notch : pattern.notches) {
    for (const Polygon& stroke : notch.strokes)
      loops.push_back(there_and_back(stroke));
  }
  return loops;
}

struct FittingLabel {
  LabelPlace place;
  bool fits = false;
};

/// Heights of letters to try, millimetres, the largest first: those of large pieces can be read
/// from as far off as the whole piece can be seen.
std::vector<double> label_heights(const Polygon& outline) {
  constexpr std::array k_usual = {6.0, 5.0, 4.0, 3.0, 2.5, 2.0, 1.6, 1.3, 1.0};
  std::vector<double> heights;
  if (const double scale = letter_scale(outline); scale > 1.0) {
    for (const double height : k_usual)
      heights.push_back(scale * height);
  }
  heights.insert(heights.end(), k_usual.begin(), k_usual.end());
  std::sort(heights.rbegin(), heights.rend());
  return heights;
}

/// As large as fits between the loops; where nothing fits, small and as near to inside as can be.
/// @param smallest height, millimetres
FittingLabel label_between(std::span<const Polygon> loops, const std::vector<std::string>& lines,
                           double smallest) {
  FittingLabel label{{loops.front().front(), smallest}};
  for (const double height : label_heights(loops.front())) {
    if (height < smallest) break;
    const double half = 0.5 * k_line_pitch * height * static_cast<double>(lines.size());
    const double width = width_of(lines) * height;
    const FreeStrip strip = longest_strip(loops, {1.0, 0.0}, half, width + 2.0 * height);
    if (strip.length > 0.0) label.place = {strip.middle, height};
    label.fits = strip.length >= width;
    if (label.fits) break;
  }
  return label;
}

LabelPlace label_place(const PieceOutline& outline, std::span<const Polygon> free,
                       const std::vector<std::string>& lines) {
  const FittingLabel clear = label_between(free, lines, 1.0);
  return clear.fits ? clear.place : label_between(outline.loops, lines, 2.0).place;
}

std::optional<ClearBox> box_of(const LabelPlace& place, const std::vector<std::string>& lines) {
  if (lines.empty()) return std::nullopt;
  const Vec2 half =
      0.5 * place.height * Vec2{width_of(lines), k_line_pitch * static_cast<double>(lines.size())};
  return ClearBox{place.middle - half, place.middle + half};
}

/// The boxes of centred level texts, as lines that enclose nothing.
std::vector<Polygon> boxes_of(const std::vector<Text>& texts) {
  std::vector<Polygon> boxes;
  boxes.reserve(texts.size());
  for (const Text& text : texts) {
    const double half = 0.5 * text.height * text_width(text.text), top = text.height;
    const Vec2 at = text.at;
    boxes.push_back(
        there_and_back({at + Vec2{-half, 0.0}, at + Vec2{half, 0.0}, at + Vec2{half, top},
                        at + Vec2{-half, top}, at + Vec2{-half, 0.0}}));
  }
  return boxes;
}

std::vector<Text> label_texts(const LabelPlace& place, const std::vector<std::string>& lines) {
  std::vector<Text> texts;
  texts.reserve(lines.size());
  const double pitch = k_line_pitch * place.height;
  const double top = place.middle.y + 0.5 * pitch * static_cast<double>(lines.size());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const double middle = top - pitch * (static_cast<double>(i) + 0.5);
    texts.push_back({{place.middle.x, middle - 0.5 * place.height},
                     place.height,
                     lines[i],
                     sheet::k_annotation_color,
                     true});
  }
  return texts;
}

}  // namespace

Vec2 grain_on_sheet(const Grain& grain, const TriMesh& mesh, const PatternGeometry& pattern) {
  if (const auto* degrees = std::get_if<double>(&grain)) {
    const double angle = *degrees * std::numbers::pi / 180.0;
    return {math::cos(angle), math::sin(angle)};
  }
  return grain_direction(mesh, pattern.positions, std::get<Vec3>(grain), pattern.outline.piece);
}

PatternGeometry annotated(PatternGeometry pattern, const TriMesh& mesh) {
  const PatternOptions& options = pattern.options;
  const PieceOutline& outline = pattern.outline;
  const std::vector<std::string> lines = lines_of(options.label, options.is_half());
  check_marks(pattern.positions.size(), options.marks, outline.piece);
  pattern.inner_lines = all_inner_lines(pattern);
  pattern.marks.clear();
  for (const Mark& mark : options.marks)
    pattern.marks.push_back(place_of(mark, pattern.positions));
  if (options.fold) pattern.fold = fold_line(pattern);
  std::vector<Text> beside_edges = edge_texts(outline, options);
  std::vector<Polygon> free = free_loops(pattern);
  for (Polygon& box : boxes_of(beside_edges))
    free.push_back(std::move(box));
  const LabelPlace place = lines.empty() ? LabelPlace{} : label_place(outline, free, lines);
  if (options.grain) {
    const Vec2 direction = grain_on_sheet(*options.grain, mesh, pattern);
    PieceOutline clear = outline;
    clear.loops = free;
    pattern.grain = grain_lines(clear, direction, box_of(place, lines));
    if (pattern.grain.empty())
      pattern.grain = grain_lines(outline, direction, box_of(place, lines));
  }
  pattern.texts = label_texts(place, lines);
  std::move(beside_edges.begin(), beside_edges.end(), std::back_inserter(pattern.texts));
  return pattern;
}

std::vector<Layer> piece_layers(const PatternGeometry& pattern) {
  CutPaths cut = cut_paths(pattern, k_cut, k_hole);
  return {outline_layer("seam", seam_paths(pattern, k_seam)),
          notch_layer(pattern),
          grain_layer(pattern.grain),
          fold_layer(pattern),
          drill_layer(pattern),
          layer_of("internal", pattern.inner_lines, k_internal),
          {"annotation", {pattern.texts.begin(), pattern.texts.end()}},
          outline_layer("hole", std::move(cut.holes)),
          outline_layer("cut", std::move(cut.outer))};
}

std::string line_words(std::span<const Layer> layers) {
  struct Words {
    std::string_view layer, text;
  };
  constexpr std::array<Words, 8> k_words = {{{"cut", "red: cut"},
                                             {"hole", "olive: cut out"},
                                             {"seam", "grey: sew"},
                                             {"notch", "pink: notch"},
                                             {"grain", "green: grain"},
                                             {"fold", "orange: fold"},
                                             {"drill", "blue: mark"},
                                             {"internal", "cyan: inner line"}}};
  std::string text;
  for (const Words& words : k_words) {
    const bool is_there = std::any_of(layers.begin(), layers.end(), [&](const Layer& layer) {
      return layer.name == words.layer && !layer.shapes.empty();
    });
    if (is_there) text += (text.empty() ? "" : " · ") + std::string(words.text);
  }
  return text;
}

}  // namespace planish
