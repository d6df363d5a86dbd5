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
  const std::span<const Vec2> pattern = unfold.pattern.positions;
  if (const auto limit = limit_of_edges(unfold.limits)) {
    const auto strains =
        largest_edge_strains_of_triangles(mesh, pattern, limit->weight_of_stretch());
    const auto band_of = [&](double strain) { return limit_band(strain, *limit); };
    return {"strain", strain_map(mesh, corners, strains, band_of, limit_band_color)};
  }
  const auto strains = signed_strains(principal_stretches(mesh, pattern));
  const double end = strain_map_limit(unfold.strain);
  const auto band_of = [&](double strain) { return strain_band(strain, end); };
  return {"strain", strain_map(mesh, corners, strains, band_of, band_color)};
}

}  // namespace

double strain_map_limit(const EdgeStrain& strain) {
  constexpr double smallest = 0.001;
  if (!(strain.p99 > smallest) || !std::isfinite(strain.p99)) return smallest;
  return round_up_125(strain.p99);
}

Drawing pattern_sheet(const Patch& patch, const UnfoldReport& unfold, const std::string& name,
                      const PatternOptions& options) {
  return pattern_sheet(patch.mesh(), unfold, pattern_geometry(patch.mesh(), unfold, name, options));
}

Drawing pattern_sheet(const TriMesh& mesh, const UnfoldReport& unfold,
                      const PatternGeometry& pattern) {
  Drawing sheet{pattern.name,
                pattern.sheet_size.x,
                pattern.sheet_size.y,
                {},
                {piece_of(pattern.options.label)},
                pattern.options.date};
  sheet.layers.reserve(k_sheet_layers.size());
  sheet.layers.push_back(map_layer(mesh, unfold, pattern.positions));
  std::vector<Layer> of_piece = piece_layers(pattern);
  const std::string lines = line_words(of_piece);
  const auto cut = of_piece.end() - 2;  // holes and outline, over all
  std::move(of_piece.begin(), cut, std::back_inserter(sheet.layers));
  sheet.layers.push_back(sheet_label(unfold, pattern, lines));
  sheet.layers.push_back(map_legend(unfold));
  std::move(cut, of_piece.end(), std::back_inserter(sheet.layers));
  sheet.notes = sheet_notes(unfold, pattern, lines);
  return sheet;
}

Drawing without_map(Drawing sheet) {
  for (Layer& layer : sheet.layers) {
    if (layer.name == "strain" || layer.name == "legend") layer.shapes.clear();
  }
  return sheet;
}

}  // namespace planish
