#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <utility>
#include <variant>

#include <planish/sheet/pattern_sheet.h>

#include "draw/scale_limit.h"
#include "sheet/annotations.h"
#include "sheet/limit_map.h"
#include "sheet/pattern_on_sheet.h"
#include "sheet/piece/outlines.h"
#include "sheet/sheet_label.h"
#include "sheet/strain_map.h"
#include "unfold/strain/vertex_strain.h"

namespace planish {

namespace {

DrawingPiece piece_of(const PieceLabel& label) {
  const int quantity = std::max(1, label.quantity), mirrored = std::min(label.mirrored, quantity);
  return {label.name, label.size, quantity - mirrored, mirrored, label.fabric, label.note};
}

/// Beside the limit where one was asked for, else strain itself.
Layer map_layer(const TriMesh& mesh, const UnfoldReport& unfold, std::span<const Vec2> corners) {
  const std::vector<HalfEdge> opposite = opposite_half_edges(mesh);
  const std::span<const Vec2> pattern = unfold.pattern.positions;
  if (const auto limit = limit_of_edges(unfold.limits)) {
    const auto strains =
        largest_edge_strains_of_triangles(mesh, pattern, limit->weight_of_stretch());
    return {"strain", limit_map(mesh, opposite, corners, strains, *limit)};
  }
  const auto strains = signed_strains(principal_stretches(mesh, pattern));
  const double end = strain_map_limit(unfold.strain);
  return {"strain", strain_map(mesh, opposite, corners, strains, end)};
}

}  // namespace

double strain_map_limit(const EdgeStrain& strain) {
  constexpr double smallest = 0.001;
  if (!(strain.p99 > smallest) || !std::isfinite(strain.p99)) return smallest;
  return round_up_125(strain.p99);
}

Drawing pattern_sheet(const Patch& patch, const UnfoldReport& unfold, const std::string& name,
                      const PatternOptions& wanted) {
  const TriMesh& mesh = patch.mesh();
  const PatternOnSheet placed = pattern_on_sheet(mesh, unfold, name, wanted);
  const PlacedPattern& pattern = placed.pattern;
  Drawing sheet{name,
                placed.size.x,
                placed.size.y,
                {},
                {piece_of(placed.options.label)},
                placed.options.date};
  sheet.layers.reserve(k_sheet_layers.size());
  sheet.layers.push_back(map_layer(mesh, unfold, pattern.positions));
  std::vector<Layer> of_piece = piece_layers(mesh, pattern, placed.options);
  SheetFacts facts = placed.facts;
  facts.lines = line_words(of_piece);
  std::move(of_piece.begin(), of_piece.end() - 1, std::back_inserter(sheet.layers));
  sheet.layers.push_back(sheet_label(unfold, facts));
  sheet.layers.push_back(map_legend(unfold));
  sheet.layers.push_back(std::move(of_piece.back()));  // the cut line, over all
  sheet.notes = sheet_notes(unfold, facts);
  return sheet;
}

std::size_t notches_on_seam_line(const Drawing& sheet) {
  std::size_t count = 0;
  for (const Layer& layer : sheet.layers) {
    if (layer.name != "notch") continue;
    for (const DrawingShape& shape : layer.shapes) {
      const auto* path = std::get_if<Path>(&shape);
      if (path != nullptr && !std::holds_alternative<NotchMark>(path->mark)) ++count;
    }
  }
  return count;
}

Drawing without_map(Drawing sheet) {
  for (Layer& layer : sheet.layers) {
    if (layer.name == "strain" || layer.name == "legend") layer.shapes.clear();
  }
  return sheet;
}

}  // namespace planish
