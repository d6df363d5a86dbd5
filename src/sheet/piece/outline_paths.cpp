#include "sheet/piece/outline_paths.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>
#include <utility>
#include <variant>

#include "pattern/polygon/plane.h"
#include "sheet/piece/line_path.h"

namespace planish {

namespace {

constexpr double k_on_fold = 2e-3;  // millimetres: lines are on a grid of 0.00001 mm

/// The stretch of a fold where the pattern lies, the piece on its left.
struct PlacedFold {
  Vec2 from, to;
};

PlacedFold placed_fold(const PatternGeometry& pattern) {
  const EdgeAllowance stretch = fold_stretch(pattern.outline, *pattern.options.fold);
  return {pattern.positions[stretch.from], pattern.positions[stretch.to]};
}

/// The edge of a closed line that a place is on, which runs the same way as the fold.
std::optional<std::size_t> edge_with(const Polygon& loop, Vec2 place, const PlacedFold& fold) {
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vec2 a = loop[i], b = loop[(i + 1) % loop.size()];
    const Vec2 way = fold.to - fold.from;
    // At the corner of a fold the edge behind it, which leaves its line, is none.
    const bool runs_along =
        std::abs(cross(way, b - a)) <= k_on_fold * norm(way) && dot(way, b - a) > 0.0;
    if (runs_along && distance_to_segment(place, a, b) <= k_on_fold) return i;
  }
  return std::nullopt;
}

/// Whether a straight piece of a line is on the line of the fold and runs the same way.
bool is_on(const PlacedFold& fold, Vec2 a, Vec2 b) {
  const Vec2 way = fold.to - fold.from;
  const auto is_beside = [&](Vec2 p) {
    return std::abs(cross(way, p - fold.from)) <= k_on_fold * norm(way);
  };
  return is_beside(a) && is_beside(b) && dot(way, b - a) >= 0.0;
}

/// Pieces of a closed line that follow each other: the first, and how many.
struct PieceRun {
  std::size_t first = 0, count = 0;
};

/// The pieces from that with the fold on, as far either way as they are on the line of the fold:
/// through the allowances at its ends.
PieceRun run_around(PieceRun run, std::size_t pieces,
                    const std::function<bool(std::size_t)>& is_on_fold) {
  while (run.count < pieces && is_on_fold((run.first + run.count) % pieces))
    ++run.count;
  while (run.count < pieces && is_on_fold((run.first + pieces - 1) % pieces)) {
    run.first = (run.first + pieces - 1) % pieces;
    ++run.count;
  }
  return run;
}

/// A closed line without its part along the line of the fold. Nothing where it does not run along
/// the fold.
std::optional<Polygon> opened(const Polygon& loop, const PlacedFold& fold) {
  const auto first = edge_with(loop, fold.from, fold), last = edge_with(loop, fold.to, fold);
  if (!first || !last) return std::nullopt;
  const std::size_t count = loop.size();
  const PieceRun run =
      run_around({*first, (*last + count - *first) % count + 1}, count,
                 [&](std::size_t i) { return is_on(fold, loop[i], loop[(i + 1) % count]); });
  Polygon line;
  line.reserve(count);
  for (std::size_t k = run.count; k <= count; ++k)
    line.push_back(loop[(run.first + k) % count]);
  return line;
}

/// The same of a curve, where the fold is on one straight piece of it.
std::optional<Curve> opened(const Curve& curve, const PlacedFold& fold) {
  const std::size_t count = curve.pieces.size();
  const auto start = [&](std::size_t k) {
    return k == 0 ? curve.start : end_of(curve.pieces[k - 1]);
  };
  const auto is_on_fold = [&](std::size_t k) {
    return std::holds_alternative<LineTo>(curve.pieces[k]) &&
           is_on(fold, start(k), end_of(curve.pieces[k]));
  };
  for (std::size_t k = 0; k < count; ++k) {
    const Vec2 from = start(k), to = end_of(curve.pieces[k]);
    const bool has_fold = is_on_fold(k) && distance_to_segment(fold.from, from, to) <= k_on_fold &&
                          distance_to_segment(fold.to, from, to) <= k_on_fold;
    if (!has_fold) continue;
    const PieceRun run = run_around({k, 1}, count, is_on_fold);
    Curve open{end_of(curve.pieces[(run.first + run.count - 1) % count]), {}};
    open.pieces.reserve(count);
    for (std::size_t i = run.count; i < count; ++i)
      open.pieces.push_back(curve.pieces[(run.first + i) % count]);
    return open;
  }
  return std::nullopt;
}

Path closed_path(std::vector<Polygon> loops, FittedLines fitted, const Stroke& stroke) {
  Path path{std::move(loops), true, stroke};
  path.fitted = std::move(fitted);
  return path;
}

/// Of each edge of the outline, by loop, whether it has an allowance.
std::vector<std::vector<bool>> edges_with_allowance(const PatternGeometry& pattern) {
  const PatternOptions& options = pattern.options;
  std::vector<EdgeAllowance> stretches = options.edge_allowances;
  if (options.is_half()) stretches.push_back(fold_stretch(pattern.outline, *options.fold));
  const Allowance widths = with_edge_allowances(*options.allowance, pattern.outline, stretches);
  std::vector<std::vector<bool>> have;
  for (std::size_t k = 0; k < pattern.outline.loops.size(); ++k) {
    std::vector<bool>& of_loop = have.emplace_back();
    for (std::size_t i = 0; i < pattern.outline.loops[k].size(); ++i) {
      const double width = widths.edge_widths.empty() ? widths.width : widths.edge_widths[k][i];
      of_loop.push_back(width > 0.0 && (k == 0 || widths.holes));
    }
  }
  return have;
}

/// The runs of edges that are kept, as open lines.
void append_runs(const Polygon& loop, const std::vector<bool>& keep, std::vector<Polygon>& lines) {
  const std::size_t n = loop.size();
  for (std::size_t i = 0; i < n; ++i) {
    if (!keep[i] || keep[(i + n - 1) % n]) continue;
    Polygon& line = lines.emplace_back(Polygon{loop[i]});
    for (std::size_t k = i; keep[k % n]; ++k)
      line.push_back(loop[(k + 1) % n]);
  }
}

}  // namespace

CutPaths cut_paths(const PatternGeometry& pattern, const Stroke& outer, const Stroke& hole) {
  CutPaths cut;
  Path around{{}, true, outer}, within{{}, true, hole};
  const FittedLines& fitted = pattern.fitted_cut;
  std::optional<PlacedFold> fold;
  if (pattern.options.is_half()) fold = placed_fold(pattern);
  for (std::size_t k = 0; k < pattern.cut.size(); ++k) {
    if (auto line = fold ? opened(pattern.cut[k], *fold) : std::nullopt) {
      Path open{{*std::move(line)}, false, outer};
      if (k < fitted.few.size()) {
        if (auto few = opened(fitted.few[k], *fold)) open.fitted.few = {std::move(*few)};
      }
      if (k < fitted.curves.size()) {
        if (auto curve = opened(fitted.curves[k], *fold)) open.fitted.curves = {std::move(*curve)};
      }
      cut.outer.push_back(std::move(open));
      fold.reset();  // one line has it
      continue;
    }
    Path& path = signed_area(pattern.cut[k]) < 0.0 ? within : around;
    path.lines.push_back(pattern.cut[k]);
    if (k < fitted.few.size()) path.fitted.few.push_back(fitted.few[k]);
    if (k < fitted.curves.size()) path.fitted.curves.push_back(fitted.curves[k]);
  }
  if (!around.lines.empty()) cut.outer.push_back(std::move(around));
  if (!within.lines.empty()) cut.holes.push_back(std::move(within));
  return cut;
}

Polygon fold_line(const PatternGeometry& pattern) {
  const PatternOptions& options = pattern.options;
  const Vec2 from = pattern.positions[options.fold->from];
  const Vec2 to = pattern.positions[options.fold->to];
  if (!options.is_half()) return {from, to};
  const PlacedFold fold = placed_fold(pattern);
  for (const Polygon& loop : pattern.cut) {
    const auto line = opened(loop, fold);
    if (!line) continue;
    // The open line begins where the fold ends.
    return dot(to - from, fold.to - fold.from) > 0.0 ? Polygon{line->back(), line->front()}
                                                     : Polygon{line->front(), line->back()};
  }
  return {from, to};
}

std::vector<Path> seam_paths(const PatternGeometry& pattern, const Stroke& stroke) {
  if (!pattern.options.allowance) return {};
  const PieceOutline& outline = pattern.outline;
  const auto have = edges_with_allowance(pattern);
  const auto has_all = [](const std::vector<bool>& of_loop) {
    return std::all_of(of_loop.begin(), of_loop.end(), [](bool has) { return has; });
  };
  if (std::all_of(have.begin(), have.end(), has_all))
    return {closed_path(outline.loops, pattern.fitted_seam, stroke)};
  FittedLines fitted = pattern.fitted_seam;
  std::vector<Polygon> closed, open;
  for (std::size_t k = outline.loops.size(); k-- > 0;) {
    if (has_all(have[k])) {
      closed.insert(closed.begin(), outline.loops[k]);
      continue;
    }
    fitted = without_line(std::move(fitted), k);
    append_runs(outline.loops[k], have[k], open);
  }
  std::vector<Path> paths;
  paths.reserve(open.size() + 1);
  for (Polygon& line : open)
    paths.push_back(Path{{std::move(line)}, false, stroke});
  if (!closed.empty()) paths.push_back(closed_path(std::move(closed), std::move(fitted), stroke));
  return paths;
}

}  // namespace planish
