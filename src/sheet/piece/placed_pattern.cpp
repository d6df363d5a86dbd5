#include "sheet/piece/placed_pattern.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

#include "core/number_text.h"
#include "pattern/allowance/filled_slit.h"
#include "pattern/curves/piece_math.h"
#include "pattern/pattern_hash.h"
#include "pattern/polygon/border_walk.h"
#include "pattern/polygon/loop_box.h"
#include "pattern/polygon/winding_union.h"
#include "sheet/piece/outlines.h"

namespace planish {

namespace {

std::vector<std::vector<Index>> border_loops(const TriMesh& mesh, bool reversed) {
  auto loops = outlines(HalfEdges(mesh), [](std::size_t) { return true; });
  for (auto& loop : loops) {
    if (reversed) std::reverse(loop.begin(), loop.end());
  }
  return loops;
}

void begin_at(Index start, PieceOutline& outline) {
  for (std::size_t k = 0; k < outline.vertices.size(); ++k) {
    auto& loop = outline.vertices[k];
    const auto found = std::find(loop.begin(), loop.end(), start);
    if (found == loop.end()) continue;
    std::rotate(outline.loops[k].begin(), outline.loops[k].begin() + (found - loop.begin()),
                outline.loops[k].end());
    std::rotate(loop.begin(), found, loop.end());
  }
}

std::vector<EdgeAllowance> turned_round(std::vector<EdgeAllowance> edges) {
  for (EdgeAllowance& edge : edges)
    std::swap(edge.from, edge.to);
  return edges;
}

/// Of the same loops the other way round from the same point on.
Allowance turned_round(Allowance allowance) {
  for (std::vector<double>& widths : allowance.edge_widths)
    std::reverse(widths.begin(), widths.end());
  for (std::vector<unsigned char>& folds : allowance.folds)
    std::reverse(folds.begin(), folds.end());
  for (std::vector<int>& hems : allowance.hems)
    std::reverse(hems.begin(), hems.end());
  allowance.darts.clear();
  return allowance;
}

Vec2 mirrored_in_y_axis(Vec2 p) {
  return {0.0 - p.x, p.y};
}

/// The other way round from the same point on.
template <class Loop>
void reverse_loops(std::vector<Loop>& loops) {
  for (Loop& loop : loops) {
    if (!loop.empty()) std::reverse(loop.begin() + 1, loop.end());
  }
}

void reverse_curves(std::vector<Curve>& curves) {
  for (Curve& curve : curves)
    curve = reversed(curve);
}

void move_lines(FittedLines& lines, const std::function<Vec2(Vec2)>& motion) {
  for (Polygon& line : lines.few) {
    for (Vec2& p : line)
      p = motion(p);
  }
  for (Curve& curve : lines.curves)
    curve = moved(curve, motion);
}

/// The mirror image in the line x = 0, every line beginning at the same point.
PatternGeometry mirror_image(PatternGeometry pattern) {
  pattern = moved(std::move(pattern), mirrored_in_y_axis);
  reverse_loops(pattern.outline.loops);
  reverse_loops(pattern.outline.vertices);
  reverse_loops(pattern.cut);
  for (FittedLines* lines : {&pattern.fitted_cut, &pattern.fitted_seam}) {
    reverse_loops(lines->few);
    reverse_curves(lines->curves);
  }
  return pattern;
}

FittedLines fitted_lines(const std::vector<Polygon>& loops, const LineFit& fit,
                         std::span<const Vec2> kept) {
  if (!(fit.tolerance > 0.0)) return {};
  constexpr double few_share = 1.5;  // a polyline stays as near to its line as apparel programs ask
  FittedLines lines{{}, fit_curves(loops, fit)};
  for (const Polygon& loop : loops)
    lines.few.push_back(
        simplify_polyline(loop, {few_share * fit.tolerance, fit.length_tolerance}, kept));
  return lines;
}

/// The places of notches on the cut line.
std::vector<Vec2> places_of(const std::vector<PlacedNotch>& notches) {
  std::vector<Vec2> places;
  places.reserve(notches.size());
  for (const PlacedNotch& notch : notches)
    places.push_back(notch.at);
  return places;
}

/// @param notches on the cut line of the pattern
PatternGeometry with_fitted_lines(PatternGeometry pattern, std::span<const Vec2> notches) {
  const PatternOptions& options = pattern.options;
  pattern.fitted_cut = fitted_lines(pattern.cut, options.curves, notches);
  pattern.fitted_seam = options.allowance ? fitted_lines(pattern.outline.loops, options.curves, {})
                                          : pattern.fitted_cut;
  return pattern;
}

/// Of a double notch at the end of a fold, half of the whole has one: the other one is its mirror
/// image.
std::vector<Notch> notches_of_half(std::vector<Notch> notches, const PieceOutline& outline,
                                   const PatternOptions& options) {
  if (!options.is_half() || !options.allowance) return notches;
  const EdgeAllowance fold = fold_stretch(outline, *options.fold);
  const std::vector<Index>& vertices = outline.vertices.front();
  const BorderWalk walk(outline.loops.front());
  for (Notch& notch : notches) {
    const std::optional<Index> vertex = notch.vertex();
    if (!notch.is_double || !vertex) continue;
    if (*vertex != fold.from && *vertex != fold.to) continue;
    const auto found = std::find(vertices.begin(), vertices.end(), *vertex);
    if (found == vertices.end()) continue;
    const double aside = (*vertex == fold.to ? 0.5 : -0.5) * options.notch_sizes.spacing;
    const double way = walk.way_to(static_cast<std::size_t>(found - vertices.begin())) + aside;
    notch = Notch::at_fraction((way < 0.0 ? way + walk.length() : way) / walk.length(), notch.kind);
  }
  return notches;
}

/// 0 without.
double widest_allowance(const PatternOptions& options) {
  if (!options.allowance) return 0.0;
  double width = options.allowance->width;
  for (const EdgeAllowance& edge : options.edge_allowances)
    width = std::max(width, edge.width);
  return width;
}

/// A cut line, and the allowance that it was made with.
struct CutLine {
  std::vector<Polygon> loops;
  Allowance allowance;
};

/// Whether a loop has no allowance.
bool is_bare(const Allowance& allowance, std::size_t loop) {
  if (loop > 0 && !allowance.holes) return true;
  if (allowance.edge_widths.empty()) return !(allowance.width > 0.0);
  const std::vector<double>& widths = allowance.edge_widths[loop];
  return std::none_of(widths.begin(), widths.end(), [](double width) { return width > 0.0; });
}

/// With half of what the machine cuts away besides, everywhere but along folds.
Allowance with_kerf(Allowance allowance, const PieceOutline& outline, double kerf) {
  if (!(kerf > 0.0)) return allowance;
  if (allowance.edge_widths.empty()) {
    for (const Polygon& loop : outline.loops) {
      allowance.edge_widths.emplace_back(loop.size(), allowance.width);
      allowance.folds.emplace_back(loop.size(), 0);
    }
  }
  for (std::size_t k = 0; k < outline.loops.size(); ++k) {
    for (std::size_t i = 0; i < outline.loops[k].size(); ++i) {
      double& width = allowance.edge_widths[k][i];
      if (k > 0 && !allowance.holes) width = 0.0;
      if (allowance.folds[k][i] == 0) width += 0.5 * kerf;
    }
  }
  allowance.width += 0.5 * kerf;
  allowance.holes = true;
  return allowance;
}

/// @param hole a loop of the outline
[[noreturn]] void refuse_kerf(const PieceOutline& outline, std::size_t hole, double kerf) {
  throw Error(ErrorCode::allowance_too_wide, "piece \"" + outline.piece + "\": a kerf of " +
                                                 fixed_text(kerf, 3) +
                                                 " mm is wider than the hole at vertex " +
                                                 std::to_string(outline.vertices[hole].front()));
}

/// Before a line is moved by half of the kerf, whether the piece is wider than it.
void check_kerf(const PieceOutline& outline, double kerf) {
  const Vec2 size = loop_box(outline.loops).size();
  const double narrow = std::min(size.x, size.y);
  if (kerf < narrow || !(kerf > 0.0)) return;
  throw Error(ErrorCode::option_out_of_range,
              "piece \"" + outline.piece + "\" is " + fixed_text(narrow, 3) +
                  " mm wide, less than a kerf of " + fixed_text(kerf, 3) + " mm");
}

double area_within(std::span<const Polygon> lines) {
  double area = 0.0;
  for (const Polygon& loop : winding_union(lines))
    area += signed_area(loop);
  return area;
}

/// The area that an outline covers twice or the wrong way round.
double lapped_area(const PieceOutline& outline) {
  double area = 0.0;
  std::vector<Polygon> reversed = outline.loops;
  for (Polygon& loop : reversed) {
    area += signed_area(loop);
    std::reverse(loop.begin(), loop.end());
  }
  return area - area_within(outline.loops) + 2.0 * area_within(reversed);
}

/// The options of a pattern that overlaps itself. Where little of it does, the cut line goes around
/// both layers; else there is no allowance.
PatternOptions with_lap_noted(PatternOptions options, const PieceOutline& outline,
                              std::vector<std::string>& notes) {
  constexpr double k_most = 0.02;  // of the area
  if (!options.overlaps || (!options.allowance && !(options.kerf > 0.0))) return options;
  const double lapped = lapped_area(outline);
  const std::string laps =
      "piece \"" + outline.piece + "\" overlaps itself by " + fixed_text(lapped, 1) + " mm2";
  if (lapped <= k_most * area_within(outline.loops)) {
    notes.push_back(laps +
                    ": its cut line goes around both layers, so allowances are cut back there");
    return options;
  }
  notes.push_back(laps + ": it gets no seam allowance");
  options.allowance.reset();
  options.kerf = 0.0;
  return options;
}

/// A hole that its allowance would fill is cut without one.
CutLine cut_line(const PieceOutline& outline, const Allowance& asked,
                 std::vector<EdgeAllowance> edges, double kerf,
                 std::vector<std::string>& left_out) {
  check_kerf(outline, kerf);
  for (std::size_t bare = 0;; ++bare) {
    CutLine line{{}, with_edge_allowances(asked, outline, edges)};
    try {
      line.loops = offset_outline(outline, with_kerf(line.allowance, outline, kerf));
      return line;
    } catch (const Error& error) {
      const std::optional<std::size_t> hole = error.place().first;
      const bool fills = error.code() == ErrorCode::allowance_too_wide && hole;
      if (fills && kerf > 0.0 && is_bare(line.allowance, *hole)) refuse_kerf(outline, *hole, kerf);
      if (!fills || bare == outline.loops.size()) throw;
      left_out.push_back(std::string(error.what()) + "; this hole is cut without");
      const Index vertex = outline.vertices[*hole].front();
      edges.push_back({vertex, vertex, 0.0});
    }
  }
}

/// Those that do not fit where they are are left out, unless none fits.
std::vector<PlacedNotch> notches_that_fit(const PieceOutline& outline, std::span<const Polygon> cut,
                                          std::span<const Notch> notches, const NotchSizes& sizes,
                                          const Allowance& allowance,
                                          std::vector<std::string>& left_out) {
  const auto placed = [&](std::span<const Notch> some) {
    return place_notches(outline, cut, some, sizes, allowance);
  };
  try {
    return placed(notches);
  } catch (const Error& error) {
    if (error.code() != ErrorCode::misplaced_notch) throw;
  }
  check_notches(outline.vertices, notches, outline.piece);
  std::vector<Notch> fit;
  std::optional<Error> last;
  for (const Notch& notch : notches) {
    try {
      placed({&notch, 1});
      fit.push_back(notch);
    } catch (const Error& error) {
      last = error;
      left_out.push_back(std::string(error.what()) + "; it is left out");
    }
  }
  if (fit.empty() && last) throw Error(*last);
  return placed(fit);
}

/// Allowances of edges by vertices, as all others are; names stay.
PatternOptions with_allowances_of_edges(PatternOptions options, const PieceOutline& outline) {
  const double usual = options.allowance ? options.allowance->width : 0.0;
  for (const EdgeAllowance& edge : allowances_of_edges(outline, options.edges, usual))
    options.edge_allowances.push_back(edge);
  for (PatternEdge& edge : options.edges) {
    edge.allowance.reset();
    edge.takes_darts = edge.mirrors_ends = false;
  }
  return options;
}

/// Without what is measured on it.
PatternGeometry placed_lines(const TriMesh& mesh, std::span<const Vec2> positions, Unit unit,
                             const std::string& piece, PatternOptions wanted) {
  // Of a mirrored pattern the one that it was made from is placed, so that rounding is the same.
  PatternGeometry pattern{.options = std::move(wanted)};
  const bool mirrored = pattern.options.like && pattern.options.like->mirrored;
  pattern.positions = in_millimetres(positions, unit);
  if (mirrored)
    std::transform(pattern.positions.begin(), pattern.positions.end(), pattern.positions.begin(),
                   mirrored_in_y_axis);
  pattern.outline = piece_outline(border_loops(mesh, mirrored), pattern.positions, piece);
  if (pattern.options.like) begin_at(pattern.options.like->start, pattern.outline);
  pattern.cut = pattern.outline.loops;
  pattern.options = with_lap_noted(std::move(pattern.options), pattern.outline, pattern.left_out);
  const PatternOptions options = pattern.options;
  pattern.options = with_allowances_of_edges(
      std::move(pattern.options), mirrored ? mirror_image(pattern).outline : pattern.outline);
  std::vector<EdgeAllowance> edges =
      mirrored ? turned_round(pattern.options.edge_allowances) : pattern.options.edge_allowances;
  const bool is_half = options.is_half();
  if (is_half) edges.push_back(fold_stretch(pattern.outline, *options.fold));
  Allowance allowance = options.allowance.value_or(Allowance{});
  // Without an allowance, what tells notches where the fold is.
  if (is_half && !options.allowance) {
    allowance = with_edge_allowances({.width = 1.0}, pattern.outline, {&edges.back(), 1});
  }
  if (options.allowance || options.kerf > 0.0) {
    Allowance asked = options.allowance.value_or(Allowance{.width = 0.0});
    asked.laps = options.overlaps;
    CutLine line = cut_line(pattern.outline, asked, edges, options.kerf, pattern.left_out);
    if (options.allowance) allowance = std::move(line.allowance);
    pattern.cut = std::move(line.loops);
  }
  std::vector<std::string> no_notches;
  const auto notches_of = [&](const PatternGeometry& some, const Allowance& made_with) {
    return notches_that_fit(some.outline, some.cut,
                            notches_of_half(options.notches, some.outline, options),
                            options.notch_sizes, made_with, no_notches);
  };
  if (!mirrored) {
    pattern.notches = notches_of(pattern, allowance);
    pattern.left_out.insert(pattern.left_out.end(), no_notches.begin(), no_notches.end());
    const std::vector<Vec2> places = places_of(pattern.notches);
    return with_fitted_lines(std::move(pattern), places);
  }
  // Notches are placed on the mirrored pattern; lines are fitted on the other one.
  std::vector<PlacedNotch> notches =
      notches_of(mirror_image(pattern), turned_round(std::move(allowance)));
  std::vector<Vec2> places = places_of(notches);
  std::transform(places.begin(), places.end(), places.begin(), mirrored_in_y_axis);
  pattern = mirror_image(with_fitted_lines(std::move(pattern), places));
  pattern.notches = std::move(notches);
  pattern.left_out.insert(pattern.left_out.end(), no_notches.begin(), no_notches.end());
  return pattern;
}

}  // namespace

PatternGeometry placed_pattern(const TriMesh& mesh, std::span<const Vec2> positions, Unit unit,
                               const std::string& piece, PatternOptions options) {
  PatternGeometry pattern = placed_lines(mesh, positions, unit, piece, std::move(options));
  pattern.name = piece;
  pattern.size = loop_box(pattern.outline.loops).size();
  pattern.hash = pattern_hash(pattern.positions);
  return pattern;
}

namespace {

/// The points of legs of darts that are folded: no cut line is to lie beside them.
std::vector<Index> vertices_of_darts(const PatternGeometry& pattern) {
  std::vector<Index> vertices;
  const Allowance all = with_edge_allowances({}, pattern.outline, pattern.options.edge_allowances);
  for (const FoldedDart& dart : all.darts) {
    const std::vector<Index>& loop = pattern.outline.vertices[dart.loop];
    for (std::size_t i = dart.from; i != dart.to; i = (i + 1) % loop.size())
      vertices.push_back(loop[i]);
  }
  return vertices;
}

}  // namespace

std::vector<FilledStretch> filled_stretches(const PatternGeometry& pattern) {
  std::vector<FilledStretch> filled;
  const double widest = widest_allowance(pattern.options);
  if (!(widest > 0.0)) return filled;
  const std::vector<Index> darts = vertices_of_darts(pattern);
  for (const OutlineStretch& stretch : filled_slits(pattern.outline.loops, pattern.cut, widest)) {
    const Index middle = pattern.outline.vertices[stretch.loop][stretch.middle];
    if (std::find(darts.begin(), darts.end(), middle) == darts.end())
      filled.push_back({middle, stretch.length});
  }
  return filled;
}

PatternGeometry moved(PatternGeometry pattern, const std::function<Vec2(Vec2)>& motion) {
  const auto move = [&](std::vector<Vec2>& points) {
    for (Vec2& p : points)
      p = motion(p);
  };
  for (Polygon& loop : pattern.outline.loops)
    move(loop);
  for (Polygon& loop : pattern.cut)
    move(loop);
  move(pattern.positions);
  move_lines(pattern.fitted_cut, motion);
  move_lines(pattern.fitted_seam, motion);
  for (PlacedNotch& notch : pattern.notches) {
    const Vec2 at = motion(notch.at);
    notch.inward = motion(notch.at + notch.inward) - at;
    notch.at = at;
    for (Polygon& stroke : notch.strokes)
      move(stroke);
  }
  return pattern;
}

}  // namespace planish
