#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string_view>

#include <planish/core/version.h>
#include <planish/report/pattern_sheet.h>

#include "core/number_text.h"
#include "report/figure_text.h"
#include "report/scale_limit.h"
#include "report/strain_map.h"

namespace planish {

namespace {

// Everything in millimetres.
constexpr double k_margin = 10.0;
constexpr double k_square = 50.0;                       // side of the test square
constexpr double k_block_height = 56.0;                 // of square and texts, below the pattern
constexpr double k_gap = 8.0;                           // between that and the pattern
constexpr double k_column = k_margin + k_square + 6.0;  // where the texts begin
constexpr double k_column_width = 115.0;                // at least
constexpr double k_swatch = 5.0;                        // of the legend
constexpr double k_name_height = 6.0, k_smallest_name_height = 3.0;
constexpr double k_letter_width = 0.85;  // a letter's over a capital's height, on the safe side

constexpr Color k_black = {0, 0, 0};
constexpr Color k_red = {255, 0, 0};
constexpr Color k_dim = {80, 80, 80};

struct Box {
  Vec2 low, high;
};

Box box_of(const std::vector<std::vector<Index>>& loops, std::span<const Vec2> corners) {
  Box box = {};
  bool is_first = true;
  for (const auto& loop : loops) {
    for (const Index v : loop) {
      const Vec2 p = corners[v];
      if (is_first) box = {p, p};
      is_first = false;
      box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
      box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
    }
  }
  return box;
}

bool begins_letter(char byte) {
  return (static_cast<unsigned char>(byte) & 0xC0) != 0x80;  // not inside a UTF-8 sequence
}

// The name as large as fits, cut short where even the smallest letters do not.
Text name_text(std::string_view name, Vec2 top_left, double width) {
  const auto letters = std::count_if(name.begin(), name.end(), begins_letter);
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
  return {{top_left.x, top_left.y - height}, height, text, k_black};
}

Path rectangle(Vec2 low, double width, double height, Color color) {
  return {{{low, {low.x + width, low.y}, {low.x + width, low.y + height}, {low.x, low.y + height}}},
          true,
          Stroke{color}};
}

void add_test_square(Layer& layer) {
  layer.shapes.emplace_back(rectangle({k_margin, k_margin}, k_square, k_square, k_black));
  layer.shapes.emplace_back(Text{
      {k_margin, k_margin + k_square + 2.0}, 2.2, "50 mm – measure me before cutting", k_black});
}

void add_legend(Layer& layer, double limit) {
  const double y = k_margin + 4.5;
  for (int band = -k_bands_a_side; band <= k_bands_a_side; ++band) {
    Path swatch = rectangle({k_column + (band + k_bands_a_side) * k_swatch, y}, k_swatch, k_swatch,
                            band_color(band));
    swatch.fill = band_color(band);
    layer.shapes.emplace_back(std::move(swatch));
  }
  const double width = (2 * k_bands_a_side + 1) * k_swatch;
  layer.shapes.emplace_back(rectangle({k_column, y}, width, k_swatch, k_dim));
  layer.shapes.emplace_back(Text{{k_column, y + k_swatch + 2.0},
                                 2.2,
                                 "strain of the pattern: − shorter, + longer than on the patch",
                                 k_dim});
  const std::string end = fixed_text(100.0 * limit, 3) + " %";
  const auto label = [&](double x, const std::string& text, bool centred) {
    layer.shapes.emplace_back(Text{{x, k_margin}, 2.2, text, k_dim, centred});
  };
  label(k_column, "−" + end, false);
  label(k_column + 0.5 * width, "0", true);
  label(k_column + width - k_swatch, "+" + end, true);
}

std::string unit_note(Unit unit) {
  const std::string name(to_string(unit));
  if (unit == Unit::mm) return "model unit: mm";
  return "model unit: " + name + " (1 " + name + " = " + number_text(millimetres_per(unit)) +
         " mm)";
}

// A line of what is wrong with the pattern; empty where nothing is.
std::string warning_text(const Pattern& pattern) {
  if (pattern.overlaps) return "The pattern overlaps itself: divide the patch before cutting.";
  if (pattern.flipped_triangles > 0) return "Triangles of the pattern are flipped: do not cut.";
  return {};
}

Layer label_layer(const UnfoldReport& unfold, std::string_view name, Vec2 size,
                  double sheet_width) {
  Layer layer{"label", {}};
  add_test_square(layer);
  const double top = k_margin + k_square;
  if (!name.empty()) {
    layer.shapes.emplace_back(name_text(name, {k_column, top}, sheet_width - k_margin - k_column));
  }
  const auto line = [&](double below_top, double height, std::string text, Color color) {
    layer.shapes.emplace_back(Text{{k_column, top - below_top}, height, std::move(text), color});
  };
  line(12.5, 4.0, decimals_text(size.x, 1) + " × " + decimals_text(size.y, 1) + " mm", k_black);
  line(18.0, 2.5, unit_note(unfold.unit), k_dim);
  line(22.5, 2.5, std::string("planish ") + k_version, k_dim);
  if (std::string warning = warning_text(unfold.pattern); !warning.empty()) {
    line(29.0, 3.0, std::move(warning), k_red);
  }
  add_legend(layer, strain_map_limit(unfold.strain));
  return layer;
}

}  // namespace

double strain_map_limit(const EdgeStrain& strain) {
  constexpr double smallest = 0.001;
  if (!(strain.p99 > smallest) || !std::isfinite(strain.p99)) return smallest;
  return round_up_125(strain.p99);
}

Drawing pattern_sheet(const TriMesh& mesh, const UnfoldReport& unfold, const std::string& name) {
  const double scale = millimetres_per(unfold.unit);
  std::vector<Vec2> corners;
  corners.reserve(unfold.pattern.positions.size());
  for (const Vec2 p : unfold.pattern.positions)
    corners.push_back(scale * p);

  const std::vector<HalfEdge> opposite = opposite_half_edges(mesh);
  const auto loops = outlines(mesh, opposite, [](std::size_t) { return true; });
  const Box box = box_of(loops, corners);
  const Vec2 size = box.high - box.low;
  const Vec2 shift = Vec2{k_margin, k_margin + k_block_height + k_gap} - box.low;
  for (Vec2& p : corners)
    p = p + shift;

  const double width = std::max(k_margin + size.x, k_column + k_column_width) + k_margin;
  const double height = shift.y + box.high.y + k_margin;
  Path cut{{}, true, Stroke{k_red}};
  for (const auto& loop : loops) {
    auto& line = cut.lines.emplace_back();
    for (const Index v : loop)
      line.push_back(corners[v]);
  }
  const auto strains = signed_strains(principal_stretches(mesh, unfold.pattern.positions));
  Layer strain{"strain",
               strain_map(mesh, opposite, corners, strains, strain_map_limit(unfold.strain))};
  // The cut line comes later than the map, so that it lies on top.
  return {
      name,
      width,
      height,
      {std::move(strain), Layer{"cut", {std::move(cut)}}, label_layer(unfold, name, size, width)}};
}

}  // namespace planish
