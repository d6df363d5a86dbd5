#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <planish/report/pattern_sheet.h>

#include "report/furniture.h"
#include "report/outlines.h"
#include "report/pattern_on_sheet.h"
#include "report/scale_limit.h"
#include "report/sheet_label.h"
#include "report/strain_map.h"

namespace planish {

namespace {

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
  const PatternOnSheet placed = pattern_on_sheet(mesh, unfold, name, wanted);
  const PlacedPattern& pattern = placed.pattern;
  const std::vector<HalfEdge> opposite = opposite_half_edges(mesh);
  const auto strains = signed_strains(principal_stretches(mesh, unfold.pattern.positions));
  Drawing sheet{name, placed.size.x, placed.size.y, {}, {piece_of(placed.options.label)}};
  sheet.layers.reserve(k_sheet_layers.size());
  sheet.layers.push_back({"strain", strain_map(mesh, opposite, pattern.positions, strains,
                                               strain_map_limit(unfold.strain))});
  // The cut line comes later than the map, so that it lies on top.
  for (Layer& layer : piece_layers(mesh, pattern, placed.options))
    sheet.layers.push_back(std::move(layer));
  sheet.layers.push_back(sheet_label(unfold, placed.facts));
  return sheet;
}

}  // namespace planish
