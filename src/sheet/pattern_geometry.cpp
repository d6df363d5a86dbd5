#include <algorithm>
#include <cmath>
#include <utility>

#include <planish/sheet/pattern_geometry.h>

#include "flatten/verdict.h"
#include "pattern/polygon/loop_box.h"
#include "sheet/annotations.h"
#include "sheet/mirrored_place.h"
#include "sheet/piece/placed_pattern.h"
#include "sheet/sheet_layout.h"

namespace planish {

namespace {

using namespace sheet;

/// Puts the pattern above the sheet's block, in its margins. Of a mirrored one every x is that of
/// the pattern that it was made from, where that lies on its sheet, taken from whole millimetres.
PatternGeometry put_on_sheet(PatternGeometry pattern) {
  const bool mirrored = pattern.options.like && pattern.options.like->mirrored;
  const LoopBox box = loop_box(pattern.cut);
  const Vec2 low = mirrored ? Vec2{-box.high.x, box.low.y} : box.low;
  const Vec2 shift = Vec2{k_margin, k_margin + k_block_height + k_gap} - low;
  const double sum = std::ceil(k_margin + box.high.x - box.low.x + k_margin);
  const double right = mirrored ? sum - k_margin : k_margin + box.high.x - box.low.x;
  pattern.sheet_size = {std::max(right, k_block_right) + k_margin, shift.y + box.high.y + k_margin};
  return moved(std::move(pattern), [&](Vec2 p) {
    return mirrored ? Vec2{mirrored_place(sum, shift.x - p.x), p.y + shift.y} : p + shift;
  });
}

}  // namespace

PatternGeometry pattern_geometry(const TriMesh& mesh, const UnfoldReport& unfold,
                                 const std::string& name, PatternOptions options) {
  options.overlaps = unfold.pattern.overlaps;
  const std::string piece = options.label.name.empty() ? name : options.label.name;
  PatternGeometry pattern =
      placed_pattern(mesh, unfold.pattern.positions, unfold.unit, piece, std::move(options));
  pattern.name = name;
  pattern.filled = filled_stretches(pattern);
  return annotated(put_on_sheet(std::move(pattern)), mesh);
}

PatternGeometry pattern_geometry(const FlattenReport& report, const PatternOptions& options) {
  return pattern_geometry(report.processed.mesh(), report.unfold, report.name,
                          on_processed(options, report));
}

PatternOptions on_processed(PatternOptions options, const FlattenReport& report) {
  if (!report.source.empty()) options = renumbered(std::move(options), report.source);
  if (report.evolve.deviation.max > 0.0) options.moved = report.evolve.deviation.max;
  options.form_faults = form_faults(report.evolve);
  options.cautions = words_of(report.cautions);
  return options;
}

}  // namespace planish
