#include "mesh/carry/planar_trace.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace planish {

namespace {

/// Triangles are taken so much wider, in shares, that rounding leaves no gaps between them.
constexpr double k_wider = 1e-12;
/// Of a line's length: what is nearer is the same place.
constexpr double k_same_share = 1e-13;

double cross_z(Vec3 a, Vec3 b) {
  return a.x * b.y - a.y * b.x;
}

/// Linear functions of the place; without an area not finite.
std::array<double, 3> shares_at(const BoxTree::Corners& corners, Vec3 p) {
  const double area = cross_z(corners[1] - corners[0], corners[2] - corners[0]);
  std::array<double, 3> shares{};
  for (std::size_t k = 0; k < 3; ++k)
    shares[k] = cross_z(corners[(k + 1) % 3] - p, corners[(k + 2) % 3] - p) / area;
  return shares;
}

std::array<double, 3> between(const std::array<double, 3>& p, const std::array<double, 3>& q,
                              double t) {
  std::array<double, 3> shares{};
  for (std::size_t k = 0; k < 3; ++k)
    shares[k] = (1.0 - t) * p[k] + t * q[k];
  return shares;
}

/// Whether the line from p to q may meet a box: false where they are apart along x, along y or
/// across the line.
bool may_meet(const Box& box, Vec3 p, Vec3 q, double margin) {
  if (std::max(p.x, q.x) < box.low.x - margin || std::min(p.x, q.x) > box.high.x + margin ||
      std::max(p.y, q.y) < box.low.y - margin || std::min(p.y, q.y) > box.high.y + margin)
    return false;
  const Vec3 middle = 0.5 * (box.low + box.high), half = 0.5 * (box.high - box.low);
  const Vec3 along = q - p;
  const double apart = std::abs(cross_z(along, middle - p));
  const double wide = std::abs(along.x) * (half.y + margin) + std::abs(along.y) * (half.x + margin);
  return apart <= wide;
}

}  // namespace

std::optional<PlaceOnTriangle> PlanarTrace::place_of(Vec3 p) const {
  const ClosestPoint closest = nearest_.query(p);
  if (!(closest.squared_distance <= reach_ * reach_)) return std::nullopt;
  return PlaceOnTriangle{closest.triangle, cleared(closest.barycentric)};
}

/// Where a point that is a little beyond the border stands for; others stay.
Vec3 PlanarTrace::onto_border(Vec3 p) const {
  const ClosestPoint closest = nearest_.query(p);
  const bool is_on_edge = zeros(closest.barycentric) > 0;
  return is_on_edge && closest.squared_distance <= reach_ * reach_ ? closest.point : p;
}

std::optional<PlanarTrace::Span> PlanarTrace::span_of(std::size_t place, Vec3 p, Vec3 q) const {
  const auto at_p = shares_at(tree_.corners(place), p), at_q = shares_at(tree_.corners(place), q);
  double largest = 1.0;
  for (std::size_t k = 0; k < 3; ++k)
    largest = std::max({largest, std::abs(at_p[k]), std::abs(at_q[k])});
  if (!std::isfinite(largest)) return std::nullopt;
  const double wider = k_wider * largest;
  Span span{tree_.triangle(place)};
  for (std::size_t k = 0; k < 3; ++k) {
    const double f = at_p[k] + wider, g = at_q[k] + wider;
    if (f < 0.0 && g < 0.0) return std::nullopt;
    if (f < 0.0) span.begin = std::max(span.begin, f / (f - g));
    if (g < 0.0) span.end = std::min(span.end, f / (f - g));
  }
  if (!(span.begin < span.end)) return std::nullopt;
  return span;
}

/// By where they begin, then by triangle.
std::vector<PlanarTrace::Span> PlanarTrace::spans_of(Vec3 p, Vec3 q) const {
  constexpr double margin = 1e-11;
  std::vector<Span> spans;
  std::vector<std::size_t> waiting = {0};
  while (!waiting.empty()) {
    const std::size_t number = waiting.back();
    waiting.pop_back();
    const BoxTree::Node& node = tree_.nodes()[number];
    if (!may_meet(node.box, p, q, margin)) continue;
    if (!node.is_leaf()) {
      waiting.push_back(number + 1);
      waiting.push_back(node.second);
      continue;
    }
    for (std::size_t i = node.begin; i < node.end; ++i) {
      if (const auto span = span_of(i, p, q)) spans.push_back(*span);
    }
  }
  std::sort(spans.begin(), spans.end(), [](const Span& a, const Span& b) {
    return a.begin != b.begin ? a.begin < b.begin : a.triangle < b.triangle;
  });
  return spans;
}

bool PlanarTrace::share_corner(Index s, Index t) const {
  const Triangle &a = mesh_.triangles[s], &b = mesh_.triangles[t];
  return std::find_first_of(a.begin(), a.end(), b.begin(), b.end()) != a.end();
}

/// The span that reaches farthest, of those that go on from the last triangle if any does: so a
/// line stays on its sheet where the mesh overlaps itself.
PlanarTrace::Span PlanarTrace::next_span(std::span<const Span> spans,
                                         const std::optional<Index>& last) const {
  const auto goes_on = [&](const Span& span) { return last && share_corner(*last, span.triangle); };
  return *std::max_element(spans.begin(), spans.end(), [&](const Span& a, const Span& b) {
    const bool a_goes_on = goes_on(a), b_goes_on = goes_on(b);
    if (a_goes_on != b_goes_on) return b_goes_on;
    return a.end != b.end ? a.end < b.end : a.triangle > b.triangle;
  });
}

void PlanarTrace::follow(Vec3 p, Vec3 q, LinePieces& pieces) const {
  p = onto_border(p);
  q = onto_border(q);
  const double length = norm(q - p);
  if (!(length > 0.0)) return;
  const std::vector<Span> spans = spans_of(p, q);
  std::size_t next = 0;
  std::vector<Span> here;
  double reached = 0.0;  // up to here the line is done
  while (reached < 1.0 - k_same_share) {
    for (; next < spans.size() && spans[next].begin <= reached + k_same_share; ++next)
      here.push_back(spans[next]);
    std::erase_if(here, [&](const Span& span) { return span.end <= reached + k_same_share; });
    if (here.empty()) {
      const double back = next < spans.size() ? spans[next].begin : 1.0;
      pieces.leave((back - reached) * length);
      reached = back;
      continue;
    }
    const std::optional<Index> last =
        pieces.is_open() ? std::optional(pieces.last().triangle) : std::nullopt;
    const Span span = next_span(here, last);
    if (last && !share_corner(*last, span.triangle)) pieces.end();
    const Triangle& t = mesh_.triangles[span.triangle];
    const BoxTree::Corners corners = {mesh_.positions[t[0]], mesh_.positions[t[1]],
                                      mesh_.positions[t[2]]};
    const auto at_p = shares_at(corners, p), at_q = shares_at(corners, q);
    const auto place_at = [&](double share) {
      return PlaceOnTriangle{span.triangle, cleared(between(at_p, at_q, share))};
    };
    if (!pieces.is_open()) pieces.add(place_at(reached));
    pieces.add(place_at(span.end));
    reached = span.end;
  }
}

}  // namespace planish
