#include "sheet/sheet_label.h"

#include <algorithm>
#include <cstddef>
#include <numbers>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

#include <planish/core/version.h>
#include <planish/draw/color.h>
#include <planish/sheet/pattern_sheet.h>

#include "core/figure_text.h"
#include "core/fnv_hash.h"
#include "core/math.h"
#include "core/number_text.h"
#include "draw/text/text_lines.h"
#include "geometry/crosses_itself.h"
#include "pattern/polygon/loop_box.h"
#include "sheet/limit_map.h"
#include "sheet/piece/allowance_words.h"
#include "sheet/piece/sheet_length.h"
#include "sheet/sheet_layout.h"
#include "sheet/strain_map.h"

namespace planish {

namespace {

using namespace sheet;

constexpr double k_swatch = 5.0;  // of the legend, millimetres
constexpr double k_name_height = 6.0, k_smallest_name_height = 3.0;

bool begins_letter(char byte) {
  return (static_cast<unsigned char>(byte) & 0xC0) != 0x80;  // not inside a UTF-8 sequence
}

// The name as large as fits, cut short where even the smallest letters do not.
Text name_text(std::string_view name, Vec2 top_left, double width) {
  const auto letters = static_cast<std::ptrdiff_t>(letters_in(name));
  const double fitting = width / (k_letter_width * std::max(1.0, static_cast<double>(letters)));
  const double height = std::clamp(fitting, k_smallest_name_height, k_name_height);
  const auto room = static_cast<std::ptrdiff_t>(width / (k_letter_width * height));
  std::string text(name);
  if (letters > room) {
    std::ptrdiff_t kept = 0;
    const auto end = std::find_if(name.begin(), name.end(),
                                  [&](char byte) { return begins_letter(byte) && ++kept == room; });
    text = std::string(name.begin(), end) + "…";
  }
  return {{top_left.x, top_left.y - height}, height, text, k_label_color};
}

Path rectangle(Vec2 low, double width, double height, Color color) {
  return {{{low, {low.x + width, low.y}, {low.x + width, low.y + height}, {low.x, low.y + height}}},
          true,
          Stroke{color}};
}

Path filled_rectangle(Vec2 low, double width, double height, Color color) {
  Path path = rectangle(low, width, height, color);
  path.stroke.reset();
  path.fill = color;
  return path;
}

void add_test_squares(Layer& layer) {
  const auto add = [&](double left, double side, const std::string& text) {
    layer.shapes.emplace_back(rectangle({left, k_margin}, side, side, k_label_color));
    layer.shapes.emplace_back(Text{{left, k_margin + side + 2.0}, 2.2, text, k_label_color});
  };
  add(k_margin, k_square, "50 mm – measure before cutting");
  add(k_block_right - k_inch_square, k_inch_square, "2 in");
}

void add_legend(Layer& layer, double limit) {
  const double y = k_margin + 4.5;
  for (int band = -k_bands_a_side; band <= k_bands_a_side; ++band) {
    const Vec2 low = {k_column + (band + k_bands_a_side) * k_swatch, y};
    layer.shapes.emplace_back(filled_rectangle(low, k_swatch, k_swatch, band_color(band)));
  }
  const double width = (2 * k_bands_a_side + 1) * k_swatch;
  layer.shapes.emplace_back(rectangle({k_column, y}, width, k_swatch, k_legend_color));
  layer.shapes.emplace_back(Text{{k_column, y + k_swatch + 2.0},
                                 2.2,
                                 "strain of the pattern: − shorter, + longer than on the patch",
                                 k_legend_color});
  const std::string end = fixed_text(100.0 * limit, 3) + " %";
  const auto label = [&](double x, const std::string& text, bool centred) {
    layer.shapes.emplace_back(Text{{x, k_margin}, 2.2, text, k_legend_color, centred});
  };
  label(k_column, "−" + end, false);
  label(k_column + 0.5 * width, "0", true);
  label(k_column + width - k_swatch, "+" + end, true);
}

/// The same where strain is shown beside its limit: ten fields for what is within, and one apart.
void add_limit_legend(Layer& layer, const MapLimit& limit) {
  constexpr double field = 8.5, gap = 4.0, beyond = 16.0;
  const double y = k_margin + 4.5;
  const auto swatch = [&](double x, double width, Color color) {
    layer.shapes.emplace_back(filled_rectangle({x, y}, width, k_swatch, color));
  };
  const auto label = [&](double x, double below, std::string text, bool centred) {
    layer.shapes.emplace_back(Text{{x, below}, 2.2, std::move(text), k_legend_color, centred});
  };
  for (int band = 0; band + 1 < k_limit_bands; ++band)
    swatch(k_column + band * field, field, limit_band_color(band));
  const double end = k_column + (k_limit_bands - 1) * field, apart = end + gap;
  layer.shapes.emplace_back(rectangle({k_column, y}, end - k_column, k_swatch, k_legend_color));
  swatch(apart, beyond, k_beyond_limit);
  label(k_column, y + k_swatch + 2.0, "limit of strain used up; the limit is " + limit.words,
        false);
  label(k_column, k_margin, "0", false);
  label(0.5 * (k_column + end), k_margin, "50 %", true);
  label(end - 2.0, k_margin, "100 %", true);
  label(apart + 0.5 * beyond, k_margin, "beyond", true);
}

/// What the eye is to find: a ring, at least 20 mm wide, around the places where the outline
/// crosses itself.
void add_overlap_ring(const std::vector<Polygon>& loops, Layer& layer) {
  constexpr int corners = 48;
  constexpr std::size_t most = 1000;
  std::vector<Polygon> places(1);
  for (const Polygon& loop : loops) {
    for (const Vec2 p : self_crossings(loop, most - places[0].size()))
      places[0].push_back(p);
  }
  if (places[0].empty()) return;
  const LoopBox box = loop_box(places);
  const Vec2 middle = 0.5 * (box.low + box.high);
  const double radius = std::max(10.0, 0.5 * norm(box.size()) + 5.0);
  Path ring{{{}}, true, Stroke{k_warning_color, 0.5}};
  for (int k = 0; k < corners; ++k) {
    const auto [sine, cosine] = math::sincos(2.0 * std::numbers::pi * k / corners);
    ring.lines[0].push_back(middle + radius * Vec2{cosine, sine});
  }
  layer.shapes.emplace_back(std::move(ring));
}

std::string unit_note(Unit unit, double model_scale) {
  const std::string name(to_string(unit));
  std::string text = "model unit: " + name;
  if (unit != Unit::mm) text += " (1 " + name + " = " + number_text(millimetres_per(unit)) + " mm)";
  if (model_scale != 1.0) text += ", model multiplied by " + number_text(model_scale);
  return text;
}

std::string percent_text(double share) {
  return fixed_text(100.0 * share, 2) + " %";
}

std::string strain_text(const UnfoldReport& unfold, const std::optional<double>& moved) {
  std::string text = "strain rms " + percent_text(unfold.strain.rms) + " · largest " +
                     percent_text(unfold.strain.max);
  if (moved)
    text += " · moved up to " + fixed_text(millimetres_per(unfold.unit) * *moved, 1) + " mm";
  return text;
}

/// Whether the pattern may be cut.
struct Verdict {
  std::string text;
  bool is_bad = false;
};

/// Whether nothing is known against the pattern but what the mesh cannot show.
std::optional<Verdict> verdict_without_limit(const PatternOptions& facts) {
  if (!facts.form_faults.empty())
    return Verdict{"Before cutting: the form " + facts.form_faults, true};
  if (!facts.cautions.empty()) return Verdict{"Before cutting, see the mesh: " + facts.cautions};
  return std::nullopt;
}

/// What speaks most against cutting the pattern, or else that it keeps its limit; none without.
std::optional<Verdict> verdict_of(const UnfoldReport& unfold, const PatternOptions& facts) {
  if (unfold.pattern.overlaps)
    return Verdict{"The pattern overlaps itself (red ring): divide the patch.", true};
  if (unfold.pattern.flipped_triangles > 0)
    return Verdict{"Triangles of the pattern are flipped: do not cut.", true};
  const bool is_bad = !facts.form_faults.empty();
  const std::string form = "the form " + facts.form_faults;
  if (unfold.limits.empty()) return verdict_without_limit(facts);
  const auto missed = std::find_if(unfold.limits.begin(), unfold.limits.end(),
                                   [](const LimitCheck& limit) { return !limit.met; });
  if (missed == unfold.limits.end())
    return Verdict{"keeps the limit " + limit_words(unfold.limits.front()) +
                       (is_bad                   ? ", but " + form
                        : facts.cautions.empty() ? ""
                                                 : ", but see the mesh: " + facts.cautions),
                   is_bad};
  return Verdict{"Beyond the limit " + limit_words(*missed) + ": " + percent_text(missed->value),
                 true};
}

std::string size_text(const PatternGeometry& pattern) {
  const std::string allowance = allowance_words(pattern.outline, pattern.options);
  const Unit unit = pattern.options.sheet_unit;
  const int decimals = unit == Unit::mm ? 1 : 2;
  return decimals_text(pattern.size.x / millimetres_per(unit), decimals) + " × " +
         sheet_length(pattern.size.y, unit, 1) + (allowance.empty() ? "" : " + " + allowance) +
         (pattern.options.kerf > 0.0 ? ", kerf " + short_sheet_length(pattern.options.kerf, unit, 3)
                                     : "");
}

/// Empty where the allowance fills no slit.
std::string filled_slit_text(const PatternGeometry& pattern) {
  double length = 0.0;
  for (const FilledStretch& stretch : pattern.filled)
    length += stretch.length;
  if (!(length > 0.0)) return {};
  return short_sheet_length(length, pattern.options.sheet_unit, 0) +
         " of seam line in slits or darts that the allowance fills";
}

std::string origin_text(const PatternGeometry& pattern) {
  std::string text = std::string("planish ") + k_version + " · scale 1:1";
  if (!pattern.options.date.empty()) text += " · " + pattern.options.date;
  return text + " · pattern " + hash_text(pattern.hash);
}

/// That which the triangles run around counter-clockwise: a pattern is never laid mirrored.
constexpr const char* k_side = "outer side up";

struct Row {
  std::string text;
  Color color;
};

/// What there is to say beside the size.
std::vector<Row> facts_of(const UnfoldReport& unfold, const PatternGeometry& pattern,
                          const std::string& lines) {
  const PatternOptions& options = pattern.options;
  std::vector<Row> rows = {{unit_note(unfold.unit, options.model_scale), k_label_color},
                           {k_side, k_label_color},
                           {origin_text(pattern), k_label_color},
                           {strain_text(unfold, options.moved), k_label_color}};
  if (std::optional<Verdict> verdict = verdict_of(unfold, options))
    rows.push_back({std::move(verdict->text), verdict->is_bad ? k_warning_color : k_label_color});
  for (std::string text : {lines, filled_slit_text(pattern)}) {
    if (!text.empty()) rows.push_back({std::move(text), k_label_color});
  }
  return rows;
}

/// The letters that fit in the column.
constexpr double k_smallest_letter = 2.0;
constexpr auto k_column_letters =
    static_cast<std::size_t>(k_column_width / (k_letter_width * k_smallest_letter));

/// As high as fits in the column.
double letter_height(const std::string& text, double usual) {
  const double letters = std::max(1.0, static_cast<double>(letters_in(text)));
  return std::min(usual, k_column_width / (k_letter_width * letters));
}

/// Each as wide as the column at most.
/// @param size_lines what size_text() says; the first one is no row
std::vector<Row> rows_of(const UnfoldReport& unfold, const PatternGeometry& pattern,
                         const std::string& lines, std::span<const std::string> size_lines) {
  std::vector<Row> rows;
  for (const std::string& line : size_lines.subspan(1))
    rows.push_back({line, k_label_color});
  for (const Row& row : facts_of(unfold, pattern, lines)) {
    for (std::string& line : broken_lines(row.text, k_column_letters))
      rows.push_back({std::move(line), row.color});
  }
  return rows;
}

/// Between the size and the legend, in letters as large as fit.
void add_rows(const std::vector<Row>& rows, Layer& layer) {
  constexpr double first = k_margin + k_square - 17.5, last = k_margin + 15.0;  // from below
  constexpr double usual_pitch = 4.0, usual_height = 2.5, height_of_pitch = 0.7;
  const double gaps = std::max(1.0, static_cast<double>(rows.size()) - 1.0);
  const double pitch = std::min(usual_pitch, (first - last) / gaps);
  double y = first;
  for (const Row& row : rows) {
    const double height = letter_height(row.text, std::min(usual_height, height_of_pitch * pitch));
    layer.shapes.emplace_back(Text{{k_column, y}, height, row.text, row.color});
    y -= pitch;
  }
}

}  // namespace

Layer sheet_label(const UnfoldReport& unfold, const PatternGeometry& pattern,
                  const std::string& lines) {
  Layer layer{"label", {}};
  add_test_squares(layer);
  const double top = k_margin + k_square;
  if (!pattern.name.empty())
    layer.shapes.emplace_back(name_text(pattern.name, {k_column, top}, k_column_width));
  const std::vector<std::string> size_lines = broken_lines(size_text(pattern), k_column_letters);
  layer.shapes.emplace_back(Text{{k_column, top - 12.5},
                                 letter_height(size_lines.front(), 4.0),
                                 size_lines.front(),
                                 k_label_color});
  add_rows(rows_of(unfold, pattern, lines, size_lines), layer);
  if (unfold.pattern.overlaps) add_overlap_ring(pattern.outline.loops, layer);
  return layer;
}

std::vector<std::string> sheet_notes(const UnfoldReport& unfold, const PatternGeometry& pattern,
                                     const std::string& lines) {
  std::vector<std::string> notes = {size_text(pattern)};
  for (Row& row : facts_of(unfold, pattern, lines))
    notes.push_back(std::move(row.text));
  return notes;
}

Layer map_legend(const UnfoldReport& unfold) {
  Layer layer{"legend", {}};
  if (const auto limit = limit_of_edges(unfold.limits)) {
    add_limit_legend(layer, *limit);
  } else {
    add_legend(layer, strain_map_limit(unfold.strain));
  }
  return layer;
}

}  // namespace planish
