#include "panels/seam_tracer.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <planish/mesh/geodesic.h>

#include "mesh/geodesic/sleeve.h"
#include "mesh/mean_edge.h"

namespace planish {

namespace {

// A traced line that is longer than what was drawn by so much went around the edge of a thin part
// to its other side and back, say: a share, and mean edges.
constexpr double k_longer = 1.3, k_detour = 12.0;
constexpr double k_sharp = 0.05;  // angle defect of a vertex that seams hold on to
constexpr double k_same = 1e-12;  // in sizes of the mesh

double length_of(const DrawnLine& line) {
  double length = 0.0;
  for (std::size_t i = 1; i < line.points.size(); ++i)
    length += norm(line.points[i] - line.points[i - 1]);
  return length;
}

}  // namespace

SeamTracer::SeamTracer(const Patch& product)
    : product_(product),
      unfolded_(product),
      mean_edge_(mean_edge_length(product.mesh())),
      is_sharp_(product.vertex_count(), 0) {
  for (Index v = 0; v < product.vertex_count(); ++v) {
    if (product.is_border(v) || product.ring(v).empty()) continue;
    const double defect = 2.0 * std::numbers::pi - unfolded_.angle_around(v);
    is_sharp_[v] = std::abs(defect) > k_sharp ? 1 : 0;
  }
}

std::vector<SurfaceLine> SeamTracer::traced(std::span<const DrawnLine> drawn) const {
  if (drawn.empty()) return {};
  TracedLines found = trace_lines(product_, {{drawn.begin(), drawn.end()}, {}});
  if (drawn.size() == 1) found.lines = {joined(found.lines)};
  // Each drawn line that is all on the product gives one, if it is longer than nothing.
  const bool is_one_each = found.outside_length == 0.0 && found.lines.size() == drawn.size();
  if (drawn.size() == 1 || is_one_each) {
    for (std::size_t k = 0; k < drawn.size(); ++k) {
      SurfaceLine& line = found.lines[k];
      const double more =
          planish::length_of(line, product_.positions()) - k_longer * length_of(drawn[k]);
      if (more > k_detour * mean_edge_) line = tight(line);
    }
    return std::move(found.lines);
  }
  std::vector<SurfaceLine> lines;
  for (const auto half : {drawn.first(drawn.size() / 2), drawn.subspan(drawn.size() / 2)}) {
    for (SurfaceLine& line : traced(half))
      lines.push_back(std::move(line));
  }
  return lines;
}

SurfaceLine SeamTracer::joined(std::span<const SurfaceLine> parts) const {
  SurfaceLine whole;
  for (const SurfaceLine& part : parts) {
    const bool goes_on = whole.empty() || norm(unfolded_.position(whole.back()) -
                                               unfolded_.position(part.front())) <= k_same;
    if (!goes_on) {
      const std::vector<SurfacePoint> bridge =
          geodesic(product_, whole.back(), part.front()).points;
      whole.insert(whole.end(), bridge.begin(), bridge.end());
    }
    whole.insert(whole.end(), part.begin() + (whole.empty() ? 0 : 1), part.end());
  }
  return whole;
}

SurfaceLine SeamTracer::tight(std::span<const SurfacePoint> part) const {
  std::vector<SurfacePoint> places;
  for (const SurfacePoint& place : part) {
    SurfacePoint checked = unfolded_.checked(place);
    const bool is_same = !places.empty() && norm(unfolded_.position(checked) -
                                                 unfolded_.position(places.back())) <= k_same;
    if (!is_same) places.push_back(checked);
  }
  if (places.size() < 2) return {part.begin(), part.end()};
  SurfaceLine line =
      drawn_tight(unfolded_, sleeve_of(unfolded_, places), places.front(), places.back(), {})
          .points;
  line.front() = part.front();
  line.back() = part.back();
  return line;
}

bool SeamTracer::is_sharp(const SurfacePoint& place) const {
  return std::any_of(place.corners.begin(), place.corners.end(),
                     [&](Index v) { return is_sharp_[v] != 0; });
}

SurfaceLine SeamTracer::fair(SurfaceLine line, double part, int rounds) const {
  for (int round = 0; round < rounds; ++round) {
    const double whole = planish::length_of(line, product_.positions());
    if (!(whole > 0.0)) return line;
    // Parts of one length; in every second round the first and the last are halves.
    const double count = std::max(1.0, std::floor(whole / (part * mean_edge_)));
    const double shift = round % 2 == 0 ? 1.0 : 0.5;
    SurfaceLine next;
    double length = 0.0;
    std::size_t first = 0, parts = 0;
    for (std::size_t i = 1; i < line.size(); ++i) {
      length += planish::length_of(std::span(line).subspan(i - 1, 2), product_.positions());
      const double end = (static_cast<double>(parts) + shift) * whole / count;
      if (length < end && i + 1 < line.size() && !is_sharp(line[i])) continue;
      while ((static_cast<double>(parts) + shift) * whole / count <= length)
        ++parts;
      const SurfaceLine drawn = tight(std::span(line).subspan(first, i + 1 - first));
      next.insert(next.end(), drawn.begin() + (next.empty() ? 0 : 1), drawn.end());
      first = i;
    }
    line = std::move(next);
  }
  return line;
}

}  // namespace planish
