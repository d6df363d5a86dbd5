#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>

#include <planish/core/error.h>
#include <planish/pattern/allowance.h>

#include "core/number_text.h"
#include "pattern/allowance/darts.h"
#include "pattern/polygon/plane.h"

namespace planish {

namespace {

std::optional<LoopStretch> stretch_of(const EdgeAllowance& edge,
                                      std::span<const std::vector<Index>> border) {
  for (std::size_t k = 0; k < border.size(); ++k) {
    const auto place = [&](Index vertex) {
      const auto found = std::find(border[k].begin(), border[k].end(), vertex);
      return static_cast<std::size_t>(found - border[k].begin());
    };
    const LoopStretch stretch = {k, place(edge.from), place(edge.to)};
    if (stretch.from < border[k].size() && stretch.to < border[k].size()) return stretch;
  }
  return std::nullopt;
}

std::string fold_text(std::string_view piece, const FoldLine& fold) {
  return "piece \"" + std::string(piece) + "\": the fold from vertex " + std::to_string(fold.from) +
         " to " + std::to_string(fold.to);
}

/// The largest distance of a stretch from the line between its ends.
double bow_of(const PieceOutline& outline, const LoopStretch& stretch) {
  const Polygon& loop = outline.loops[stretch.loop];
  double bow = 0.0;
  for (std::size_t at = stretch.from; at != stretch.to; at = (at + 1) % loop.size()) {
    bow = std::max(bow, distance_to_segment(loop[at], loop[stretch.from], loop[stretch.to]));
  }
  return bow;
}

}  // namespace

void check_edge_allowances(std::span<const std::vector<Index>> border,
                           std::span<const EdgeAllowance> edges, std::string_view piece) {
  for (const EdgeAllowance& edge : edges) {
    if (stretch_of(edge, border)) continue;
    throw Error(ErrorCode::misplaced_allowance,
                "piece \"" + std::string(piece) + "\": the seam allowance from vertex " +
                    std::to_string(edge.from) + " to " + std::to_string(edge.to) +
                    " is off the border: both must be on one border of the piece",
                {.path = {}, .first = edge.from});
  }
}

void check_fold(std::span<const std::vector<Index>> border, const FoldLine& fold,
                std::string_view piece) {
  if (fold.from != fold.to && stretch_of({fold.from, fold.to}, border)) return;
  throw Error(ErrorCode::misplaced_allowance,
              fold_text(piece, fold) +
                  " is off the border: its ends must be two vertices of one border of the piece",
              {.path = {}, .first = fold.from});
}

EdgeAllowance fold_stretch(const PieceOutline& outline, const FoldLine& fold) {
  constexpr double k_straight = 0.5, k_share = 0.001;
  check_fold(outline.vertices, fold, outline.piece);
  const LoopStretch ahead = *stretch_of({fold.from, fold.to}, outline.vertices);
  const LoopStretch back = {ahead.loop, ahead.to, ahead.from};
  const double bow = bow_of(outline, ahead), bow_back = bow_of(outline, back);
  const Polygon& loop = outline.loops[ahead.loop];
  const double length = norm(loop[ahead.to] - loop[ahead.from]);
  if (std::min(bow, bow_back) > std::max(k_straight, k_share * length)) {
    throw Error(
        ErrorCode::misplaced_allowance,
        fold_text(outline.piece, fold) + " is not straight: it is " +
            fixed_text(std::min(bow, bow_back), 1) +
            " mm off the line between its ends, and material folds along a straight line only; "
            "a fold becomes straight where it lies in one plane of the model, but for a "
            "thousandth of its length: take two ends between which it does, or leave out "
            "the fold and give both halves an allowance there, to be sewn together",
        {.path = {}, .first = fold.from});
  }
  return bow <= bow_back ? EdgeAllowance{fold.from, fold.to, 0.0, true}
                         : EdgeAllowance{fold.to, fold.from, 0.0, true};
}

namespace {

PieceOutline mirror_image(PieceOutline outline) {
  for (std::size_t k = 0; k < outline.loops.size(); ++k) {
    for (Vec2& p : outline.loops[k])
      p.x = 0.0 - p.x;
    std::reverse(outline.loops[k].begin(), outline.loops[k].end());
    std::reverse(outline.vertices[k].begin(), outline.vertices[k].end());
  }
  return outline;
}

/// An edge of the outline by its vertices.
struct EdgeEnds {
  std::size_t loop;
  Index from, to;

  bool operator==(const EdgeEnds&) const = default;
};

/// The points of an edge from one end on, as far as its allowance is wide; fewer where they are off
/// a straight line, but at least two.
std::size_t straight_points(const Polygon& loop, const std::vector<std::size_t>& points,
                            double width) {
  constexpr double k_straight = 0.4;  // millimetres
  const Vec2 start = loop[points.front()];
  std::size_t count = 2;
  while (count < points.size() && norm(loop[points[count - 1]] - start) < width) {
    const Vec2 end = loop[points[count]];
    for (std::size_t k = 1; k < count; ++k) {
      if (distance_to_segment(loop[points[k]], start, end) > k_straight) return count;
    }
    ++count;
  }
  return count;
}

/// Hems at both ends of an edge, as far as it is straight there.
void add_mirrored_ends(const PieceOutline& outline, const EdgeEnds& ends, double width,
                       std::vector<EdgeAllowance>& allowances) {
  if (!(width > 0.0)) return;
  for (const OutlineEdge& edge : edges_between_corners(outline)) {
    const std::vector<Index>& vertices = outline.vertices[edge.loop];
    if (edge.loop != ends.loop || vertices[edge.points.front()] != ends.from) continue;
    const Polygon& loop = outline.loops[edge.loop];
    std::vector<std::size_t> points = edge.points;
    const std::size_t before = straight_points(loop, points, width);
    const Index first = vertices[points[before - 1]];
    std::reverse(points.begin(), points.end());
    const std::size_t behind = straight_points(loop, points, width);
    const Index last = vertices[points[behind - 1]];
    if (before + behind > points.size()) {
      allowances.push_back({ends.from, ends.to, width, false, true});
    } else {
      allowances.push_back({ends.from, first, width, false, true});
      allowances.push_back({last, ends.to, width, false, true});
    }
  }
}

/// @param clockwise the outline is the mirror image of the one whose edges are counted
std::vector<EdgeEnds> edge_ends(const PieceOutline& outline, bool clockwise) {
  const PieceOutline counted = clockwise ? mirror_image(outline) : outline;
  std::vector<EdgeEnds> ends;
  for (const OutlineEdge& edge : edges_between_corners(counted)) {
    const std::vector<Index>& vertices = counted.vertices[edge.loop];
    const Index from = vertices[edge.points.front()], to = vertices[edge.points.back()];
    ends.push_back(clockwise ? EdgeEnds{edge.loop, to, from} : EdgeEnds{edge.loop, from, to});
  }
  return ends;
}

}  // namespace

std::vector<EdgeAllowance> allowances_of_edges(const PieceOutline& outline,
                                               std::span<const PatternEdge> edges, double usual) {
  std::vector<EdgeAllowance> allowances;
  for (const PatternEdge& edge : edges) {
    const std::vector<EdgeEnds> ends = edge_ends(outline, edge.clockwise);
    if (edge.number < 1 || static_cast<std::size_t>(edge.number) > ends.size()) {
      throw Error(ErrorCode::misplaced_allowance,
                  "piece \"" + outline.piece + "\" has no edge " + std::to_string(edge.number) +
                      ": from corner to corner there are " + std::to_string(ends.size()) +
                      ", counted counter-clockwise, as edge-lengths.csv has them");
    }
    const EdgeEnds& own = ends[static_cast<std::size_t>(edge.number) - 1];
    if (edge.allowance)
      allowances.push_back({own.from, own.to, *edge.allowance, false, edge.is_hem});
    if (edge.takes_darts) allowances.push_back({own.from, own.to, 0.0, false, false, true});
    if (edge.mirrors_ends)
      add_mirrored_ends(outline, own, edge.allowance.value_or(usual), allowances);
  }
  return allowances;
}

std::vector<std::string> words_of_edges(const PieceOutline& outline,
                                        std::span<const PatternEdge> edges) {
  const std::vector<EdgeEnds> here = edge_ends(outline, false);
  std::vector<std::string> words;
  for (std::size_t e = 0; e < here.size(); ++e)
    words.push_back(PatternEdge{static_cast<int>(e) + 1}.words());
  for (const PatternEdge& edge : edges) {
    const std::vector<EdgeEnds> ends = edge_ends(outline, edge.clockwise);
    const auto number = static_cast<std::size_t>(edge.number);
    if (edge.name.empty() || number < 1 || number > ends.size()) continue;
    const auto found = std::find(here.begin(), here.end(), ends[number - 1]);
    if (found != here.end()) words[static_cast<std::size_t>(found - here.begin())] = edge.name;
  }
  return words;
}

Allowance with_edge_allowances(Allowance allowance, const PieceOutline& outline,
                               std::span<const EdgeAllowance> edges) {
  check_edge_allowances(outline.vertices, edges, outline.piece);
  if (edges.empty()) return allowance;
  allowance.edge_widths.clear();
  allowance.folds.clear();
  allowance.hems.clear();
  for (const Polygon& loop : outline.loops) {
    allowance.edge_widths.emplace_back(loop.size(), allowance.width);
    allowance.folds.emplace_back(loop.size(), 0);
    allowance.hems.emplace_back(loop.size(), 0);
  }
  int hems = 0;
  std::vector<LoopStretch> take_darts;
  for (const EdgeAllowance& edge : edges) {
    const LoopStretch stretch = *stretch_of(edge, outline.vertices);
    if (edge.takes_darts) {
      take_darts.push_back(stretch);
      continue;
    }
    const int hem = edge.is_hem ? ++hems : 0;
    std::vector<double>& widths = allowance.edge_widths[stretch.loop];
    std::size_t at = stretch.from;
    do {
      widths[at] = edge.width;
      allowance.folds[stretch.loop][at] = edge.is_fold ? 1 : 0;
      allowance.hems[stretch.loop][at] = hem;
      at = (at + 1) % widths.size();
    } while (at != stretch.to);
  }
  if (hems == 0) allowance.hems.clear();
  allowance.darts = darts_toward(outline, take_darts);
  return allowance;
}

}  // namespace planish
