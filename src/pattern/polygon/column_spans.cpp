#include "pattern/polygon/column_spans.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "pattern/polygon/polygon_edges.h"

namespace planish {

namespace {

constexpr double k_column_slack = 1e-7;  // millimetres
constexpr double k_nowhere = std::numeric_limits<double>::infinity();

/// A column's sides.
struct Slab {
  double left, right;
};

void include(Span& span, const Span& other) {
  span = {std::min(span.low, other.low), std::max(span.high, other.high)};
}

/// The heights of a line within a slab; those of nothing where it is nowhere in it.
Span heights_of_line(Vec2 a, Vec2 b, const Slab& slab) {
  if (a.x > b.x) std::swap(a, b);
  if (b.x < slab.left || a.x > slab.right) return {k_nowhere, -k_nowhere};
  const auto height_at = [&](double x) { return a.y + (x - a.x) / (b.x - a.x) * (b.y - a.y); };
  const double from = a.x < slab.left ? height_at(slab.left) : a.y;
  const double to = b.x > slab.right ? height_at(slab.right) : b.y;
  return {std::min(from, to), std::max(from, to)};
}

Span heights_of_disk(Vec2 middle, double radius, const Slab& slab) {
  const double aside = std::max({slab.left - middle.x, middle.x - slab.right, 0.0});
  if (aside > radius) return {k_nowhere, -k_nowhere};
  const double half = std::sqrt(radius * radius - aside * aside);
  return {middle.y - half, middle.y + half};
}

/// The heights, within a slab, of all that is no farther from an edge than the reach: it is convex,
/// and its border is of the edge's copies on both sides and of arcs around its ends.
Span heights_around(const PolygonEdge& edge, double reach, const Slab& slab) {
  Span span = heights_of_line(edge.a, edge.b, slab);
  if (!(reach > 0.0)) return span;
  include(span, heights_of_disk(edge.a, reach, slab));
  include(span, heights_of_disk(edge.b, reach, slab));
  const Vec2 along = edge.b - edge.a;
  const double length = norm(along);
  if (!(length > 0.0)) return span;
  const Vec2 aside = reach / length * Vec2{-along.y, along.x};
  include(span, heights_of_line(edge.a + aside, edge.b + aside, slab));
  include(span, heights_of_line(edge.a - aside, edge.b - aside, slab));
  return span;
}

/// Where an edge passes the middle of a column, and how the winding number changes upwards there.
struct Passage {
  double height;
  int change;
};

std::optional<Passage> passage_of(const PolygonEdge& edge, double x) {
  const bool before = edge.a.x <= x, after = edge.b.x <= x;
  if (before == after) return std::nullopt;
  const double height = edge.a.y + (x - edge.a.x) / (edge.b.x - edge.a.x) * (edge.b.y - edge.a.y);
  return Passage{height, before ? 1 : -1};
}

/// One column as it is put together.
struct OpenColumn {
  std::vector<Span> spans;
  std::vector<Passage> passages;
};

/// Spans that meet become one. No edge is between two that do not, so what is between is inside or
/// outside as a whole: as it is in the middle of the column.
std::vector<Span> joined(OpenColumn column) {
  std::sort(column.spans.begin(), column.spans.end(),
            [](const Span& a, const Span& b) { return a.low < b.low; });
  std::vector<Span> result;
  for (const Span& span : column.spans) {
    if (result.empty()) {
      result.push_back(span);
      continue;
    }
    Span& last = result.back();
    bool meets = span.low <= last.high;
    if (!meets) {
      const double between = 0.5 * (last.high + span.low);
      int winding = 0;
      for (const Passage& passage : column.passages)
        winding += passage.height < between ? passage.change : 0;
      meets = winding != 0;
    }
    if (meets) {
      last.high = std::max(last.high, span.high);
    } else {
      result.push_back(span);
    }
  }
  return result;
}

std::ptrdiff_t column_from(double x, double step) {
  return static_cast<std::ptrdiff_t>(std::floor((x + k_column_slack) / step));
}

std::ptrdiff_t column_to(double x, double step) {
  return static_cast<std::ptrdiff_t>(std::ceil((x - k_column_slack) / step));
}

}  // namespace

ColumnSpans column_spans(std::span<const Polygon> loops, double step, double reach) {
  const std::vector<PolygonEdge> edges = polygon_edges(loops);
  double left = k_nowhere, right = -k_nowhere;
  for (const PolygonEdge& edge : edges) {
    left = std::min(left, edge.a.x);
    right = std::max(right, edge.a.x);
  }
  ColumnSpans result;
  if (edges.empty()) return result;
  result.first = column_from(left - reach, step);
  const std::ptrdiff_t end = std::max(result.first + 1, column_to(right + reach, step));
  std::vector<OpenColumn> open(static_cast<std::size_t>(end - result.first));
  for (const PolygonEdge& edge : edges) {
    const auto [from, to] = std::minmax(edge.a.x, edge.b.x);
    const std::ptrdiff_t last = std::min(end, column_to(to + reach, step));
    for (std::ptrdiff_t k = column_from(from - reach, step); k < last; ++k) {
      OpenColumn& column = open[static_cast<std::size_t>(k - result.first)];
      const double x = static_cast<double>(k) * step;
      const Span span = heights_around(edge, reach, {x, x + step});
      if (span.low <= span.high) column.spans.push_back(span);
      if (const auto passage = passage_of(edge, x + 0.5 * step)) {
        column.passages.push_back(*passage);
      }
    }
  }
  result.columns.reserve(open.size());
  for (OpenColumn& column : open)
    result.columns.push_back(joined(std::move(column)));
  return result;
}

}  // namespace planish
