#include "sheet/pattern_on_sheet.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include <planish/sheet/pattern_sheet.h>

#include "geometry/crosses_itself.h"
#include "pattern/filled_slit.h"
#include "pattern/pattern_hash.h"
#include "pattern/polygon/loop_box.h"
#include "sheet/mirrored_place.h"
#include "sheet/piece/allowance_words.h"
#include "sheet/sheet_layout.h"

namespace planish {

namespace {

using namespace sheet;

/// 0 without.
double widest_allowance(const PatternOptions& options) {
  if (!options.allowance) return 0.0;
  double width = options.allowance->width;
  for (const EdgeAllowance& edge : options.edge_allowances)
    width = std::max(width, edge.width);
  return width;
}

std::vector<FilledStretch> filled_in(const PlacedPattern& pattern, const PatternOptions& options) {
  std::vector<FilledStretch> filled;
  const double widest = widest_allowance(options);
  if (!(widest > 0.0)) return filled;
  for (const OutlineStretch& stretch : filled_slits(pattern.outline.loops, pattern.cut, widest)) {
    filled.push_back({pattern.outline.vertices[stretch.loop][stretch.middle], stretch.length});
  }
  return filled;
}

std::optional<std::pair<Vec2, Vec2>> overlap_box(const std::vector<Polygon>& loops) {
  constexpr std::size_t most = 1000;
  std::vector<Polygon> places(1);
  for (const Polygon& loop : loops) {
    for (const Vec2 p : self_crossings(loop, most - places[0].size()))
      places[0].push_back(p);
  }
  if (places[0].empty()) return std::nullopt;
  const LoopBox box = loop_box(places);
  return std::pair(box.low, box.high);
}

/// Puts the pattern above the sheet's block, in its margins. Of a mirrored one every x is that of
/// the pattern that it was made from, where that lies on its sheet, taken from whole millimetres.
PatternOnSheet put_on_sheet(PatternOnSheet sheet, bool mirrored) {
  const LoopBox box = loop_box(sheet.pattern.cut);
  const Vec2 low = mirrored ? Vec2{-box.high.x, box.low.y} : box.low;
  const Vec2 shift = Vec2{k_margin, k_margin + k_block_height + k_gap} - low;
  const double sum = std::ceil(k_margin + box.high.x - box.low.x + k_margin);
  sheet.pattern = moved(std::move(sheet.pattern), [&](Vec2 p) {
    return mirrored ? Vec2{mirrored_place(sum, shift.x - p.x), p.y + shift.y} : p + shift;
  });
  const double right = mirrored ? sum - k_margin : k_margin + box.high.x - box.low.x;
  sheet.size = {std::max(right, k_block_right) + k_margin, shift.y + box.high.y + k_margin};
  return sheet;
}

}  // namespace

std::vector<FilledStretch> filled_stretches(const TriMesh& mesh, std::span<const Vec2> positions,
                                            Unit unit, const PatternOptions& options) {
  if (!options.allowance) return {};
  PatternOptions plain = options;
  plain.notches.clear();
  plain.curves = {.tolerance = 0.0};
  return filled_in(placed_pattern(mesh, positions, unit, options.label.name, plain), plain);
}

PatternOnSheet pattern_on_sheet(const TriMesh& mesh, const UnfoldReport& unfold,
                                const std::string& name, const PatternOptions& wanted) {
  PatternOptions options = possible_options(wanted, unfold.pattern.overlaps);
  const std::string& piece = options.label.name.empty() ? name : options.label.name;
  PlacedPattern pattern =
      placed_pattern(mesh, unfold.pattern.positions, unfold.unit, piece, options);
  const LoopBox piece_box = loop_box(pattern.outline.loops);
  SheetFacts facts = {.name = name,
                      .size = piece_box.size(),
                      .allowance = allowance_words(pattern.outline, options),
                      .hash = pattern_hash(pattern.positions),
                      .date = options.date,
                      .model_scale = options.model_scale};
  facts.form_faults = options.form_faults;
  facts.cautions = options.cautions;
  for (const FilledStretch& stretch : filled_in(pattern, options))
    facts.filled_slit += stretch.length;
  if (options.moved) facts.moved = millimetres_per(unfold.unit) * *options.moved;
  const bool mirrored = options.like && options.like->mirrored;
  PatternOnSheet sheet =
      put_on_sheet({std::move(pattern), std::move(options), std::move(facts), {}}, mirrored);
  if (unfold.pattern.overlaps) sheet.facts.overlap = overlap_box(sheet.pattern.outline.loops);
  return sheet;
}

}  // namespace planish
