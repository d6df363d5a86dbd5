#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>

#include <planish/pattern/pattern_hash.h>
#include <planish/report/pattern_sheet.h>

#include "pattern/loop_box.h"
#include "report/furniture.h"
#include "report/outlines.h"
#include "report/placed_pattern.h"
#include "report/scale_limit.h"
#include "report/sheet_label.h"
#include "report/sheet_layout.h"
#include "report/strain_map.h"

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

/// What overlaps itself has no one outer side that an allowance could be laid on.
PatternOptions possible_options(PatternOptions options, const Pattern& pattern) {
  if (pattern.overlaps) options.allowance.reset();
  return options;
}

DrawingPiece piece_of(const PieceLabel& label) {
  return {label.name, label.size, std::max(1, label.quantity)};
}

}  // namespace

double strain_map_limit(const EdgeStrain& strain) {
  constexpr double smallest = 0.001;
  if (!(strain.p99 > smallest) || !std::isfinite(strain.p99)) return smallest;
  return round_up_125(strain.p99);
}

Drawing pattern_sheet(const TriMesh& mesh, const UnfoldReport& unfold, const std::string& name,
                      const PatternOptions& wanted) {
  const PatternOptions options = possible_options(wanted, unfold.pattern);
  const std::vector<HalfEdge> opposite = opposite_half_edges(mesh);
  const std::string& piece = options.label.name.empty() ? name : options.label.name;
  PlacedPattern pattern =
      placed_pattern(mesh, unfold.pattern.positions, unfold.unit, piece, options);
  const LoopBox piece_box = loop_box(pattern.outline.loops);
  const SheetFacts facts = {name, piece_box.size(), widest_allowance(options),
                            pattern_hash(pattern.positions), options.date};

  const LoopBox box = loop_box(pattern.cut);
  const Vec2 shift = Vec2{k_margin, k_margin + k_block_height + k_gap} - box.low;
  pattern = moved(std::move(pattern), [&](Vec2 p) { return p + shift; });
  const auto strains = signed_strains(principal_stretches(mesh, unfold.pattern.positions));
  Drawing sheet{name,
                std::max(k_margin + box.high.x - box.low.x, k_block_right) + k_margin,
                shift.y + box.high.y + k_margin,
                {},
                {piece_of(options.label)}};
  sheet.layers.reserve(k_sheet_layers.size());
  sheet.layers.push_back({"strain", strain_map(mesh, opposite, pattern.positions, strains,
                                               strain_map_limit(unfold.strain))});
  // The cut line comes later than the map, so that it lies on top.
  for (Layer& layer : piece_layers(mesh, pattern, options))
    sheet.layers.push_back(std::move(layer));
  sheet.layers.push_back(sheet_label(unfold, facts));
  return sheet;
}

}  // namespace planish
