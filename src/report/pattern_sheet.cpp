#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include <planish/pattern/pattern_hash.h>
#include <planish/report/pattern_sheet.h>

#include "report/furniture.h"
#include "report/outlines.h"
#include "report/scale_limit.h"
#include "report/sheet_label.h"
#include "report/sheet_layout.h"
#include "report/strain_map.h"

namespace planish {

namespace {

using namespace sheet;

constexpr Color k_red = {255, 0, 0};

struct Box {
  Vec2 low, high;
};

Box box_of(const std::vector<Polygon>& loops) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  Box box{{inf, inf}, {-inf, -inf}};
  for (const Polygon& loop : loops) {
    for (const Vec2 p : loop) {
      box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
      box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
    }
  }
  return loops.empty() ? Box{} : box;
}

void move(std::vector<Vec2>& points, Vec2 shift) {
  for (Vec2& p : points)
    p = p + shift;
}

PlacedPattern moved(PlacedPattern pattern, Vec2 shift) {
  for (Polygon& loop : pattern.outline.loops)
    move(loop, shift);
  for (Polygon& loop : pattern.cut)
    move(loop, shift);
  move(pattern.positions, shift);
  return pattern;
}

/// In millimetres, where the unfolding put it.
PlacedPattern in_millimetres(const TriMesh& mesh, const UnfoldReport& unfold,
                             std::span<const HalfEdge> opposite, const std::string& piece) {
  const double scale = millimetres_per(unfold.unit);
  PlacedPattern pattern;
  pattern.positions.reserve(unfold.pattern.positions.size());
  for (const Vec2 p : unfold.pattern.positions)
    pattern.positions.push_back(scale * p);
  pattern.outline = piece_outline(outlines(mesh, opposite, [](std::size_t) { return true; }),
                                  pattern.positions, piece);
  pattern.cut = pattern.outline.loops;
  return pattern;
}

double widest(const std::optional<Allowance>& allowance) {
  if (!allowance) return 0.0;
  double width = allowance->edge_widths.empty() ? allowance->width : 0.0;
  for (const auto& widths : allowance->edge_widths) {
    for (const double some : widths)
      width = std::max(width, some);
  }
  return width;
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
                      const PatternOptions& options) {
  const std::vector<HalfEdge> opposite = opposite_half_edges(mesh);
  const std::string& piece = options.label.name.empty() ? name : options.label.name;
  PlacedPattern pattern = in_millimetres(mesh, unfold, opposite, piece);
  const Box piece_box = box_of(pattern.outline.loops);
  const SheetFacts facts = {name, piece_box.high - piece_box.low, widest(options.allowance),
                            pattern_hash(pattern.positions), options.date};
  if (options.allowance) pattern.cut = offset_outline(pattern.outline, *options.allowance);

  const Box box = box_of(pattern.cut);
  const Vec2 shift = Vec2{k_margin, k_margin + k_block_height + k_gap} - box.low;
  pattern = moved(std::move(pattern), shift);
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
  sheet.layers.push_back({"cut", {Path{pattern.cut, true, Stroke{k_red}}}});
  for (Layer& layer : furniture_layers(mesh, pattern, options))
    sheet.layers.push_back(std::move(layer));
  sheet.layers.push_back(sheet_label(unfold, facts));
  return sheet;
}

}  // namespace planish
