#include "energy/shape_guard.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/math.h"
#include "core/neumaier_sum.h"

namespace planish {

namespace {

constexpr std::size_t k_guard_grain = 2048;
/// Edges: a strain over the first adds its fourth power and this share of its square.
constexpr double k_edge_strain = 0.15, k_edge_quadratic_weight = 0.02;
/// Corners: weights of the square and of the eighth power.
constexpr double k_corner_quadratic_weight = 0.01, k_corner_octic_weight = 0.3;
/// A corner is guarded below this angle (radians), or below this share of its first one.
constexpr double k_sharp = 12.0 * std::numbers::pi / 180.0, k_first_angle_share = 0.8;

double corner_angle(Vec3 at, Vec3 b, Vec3 c) {
  const Vec3 u = b - at, w = c - at;
  const double sine = norm(cross(u, w)), cosine = dot(u, w);
  return sine == 0.0 && cosine == 0.0 ? 0.0 : math::atan2(sine, cosine);
}

}  // namespace

ShapeGuard::Bound ShapeGuard::bound_of(double sharp, double least_angle) {
  return {sharp, math::cos(sharp), sharp - std::min(least_angle, 0.5 * sharp)};
}

ShapeGuard::ShapeGuard(std::vector<Triangle> triangles, const std::vector<Vec3>& design,
                       double least_angle)
    : triangles_(std::move(triangles)), bounds_{bound_of(k_sharp, least_angle)} {
  NeumaierSum total;
  corner_bounds_.reserve(3 * triangles_.size());
  edges_.reserve(3 * triangles_.size());
  for (const Triangle& t : triangles_) {
    const Vec3 a = design[t[0]], b = design[t[1]], c = design[t[2]];
    const double area = 0.5 * norm(cross(b - a, c - a));
    total.add(area);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::array<Index, 3> corner = {t[k], t[(k + 1) % 3], t[(k + 2) % 3]};
      const auto [low, high] = std::minmax(corner[0], corner[1]);
      const double length = norm(design[high] - design[low]);
      if (length > 0.0) edges_.push_back({{low, high}, length, area / 3.0});
      const double angle = corner_angle(design[corner[0]], design[corner[1]], design[corner[2]]);
      const double sharp = std::min(k_sharp, k_first_angle_share * angle);
      if (sharp > 0.0 && sharp < k_sharp) bounds_.push_back(bound_of(sharp, least_angle));
      const std::size_t bound = sharp < k_sharp ? bounds_.size() - 1 : 0;
      corner_bounds_.push_back(sharp > 0.0 ? static_cast<std::uint32_t>(bound) : k_none);
    }
  }
  std::sort(edges_.begin(), edges_.end(),
            [](const Edge& a, const Edge& b) { return a.ends < b.ends; });
  std::size_t count = 0;
  for (const Edge& edge : edges_) {
    if (count > 0 && edges_[count - 1].ends == edge.ends)
      edges_[count - 1].share += edge.share;
    else
      edges_[count++] = edge;
  }
  edges_.erase(edges_.begin() + static_cast<std::ptrdiff_t>(count), edges_.end());
  edges_.shrink_to_fit();
  for (Edge& edge : edges_)
    edge.share /= total.value();
}

double ShapeGuard::edge_value(const Edge& edge, const std::vector<Vec3>& x) const {
  const double length = norm(x[edge.ends[1]] - x[edge.ends[0]]);
  const double s = (length / edge.length - 1.0) / k_edge_strain, square = s * s;
  return edge.share * square * (square + k_edge_quadratic_weight);
}

double ShapeGuard::corner_value(std::size_t c, const std::vector<Vec3>& x) const {
  if (corner_bounds_[c] == k_none) return 0.0;
  const auto [own, next, last] = corner(c);
  const Vec3 at = x[own], u = x[next] - at, w = x[last] - at;
  const Bound& bound = bounds_[corner_bounds_[c]];
  const double cosine = dot(u, w);
  if (cosine <= 0.0 ||
      cosine * cosine <= bound.sharp_cosine * bound.sharp_cosine * dot(u, u) * dot(w, w))
    return 0.0;
  const double q = (bound.sharp - math::atan2(norm(cross(u, w)), cosine)) / bound.range;
  const double square = q * q, fourth = square * square;
  return q > 0.0 ? k_corner_quadratic_weight * square + k_corner_octic_weight * fourth * fourth
                 : 0.0;
}

double ShapeGuard::value(const std::vector<Vec3>& x, ThreadPool& pool) const {
  std::vector<double> terms(edges_.size() + corner_count());
  pool.for_ranges(terms.size(), k_guard_grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      terms[k] = k < edges_.size() ? edge_value(edges_[k], x) : corner_value(k - edges_.size(), x);
    }
  });
  NeumaierSum sum;
  for (const double term : terms)
    sum.add(term);
  return sum.value();
}

Summand<2> ShapeGuard::edge_summand(std::size_t e, const std::vector<Vec3>& x) const {
  const Edge& edge = edges_[e];
  const Vec3 along = x[edge.ends[1]] - x[edge.ends[0]];
  const double length = norm(along), unit = 1.0 / (k_edge_strain * edge.length);
  if (!(length > 0.0)) return {edge.ends};
  const double s = (length - edge.length) * unit;
  const Vec3 outward = (1.0 / length) * along;
  return {edge.ends,
          edge.share * s * (4.0 * s * s + 2.0 * k_edge_quadratic_weight) * unit,
          edge.share * (12.0 * s * s + 2.0 * k_edge_quadratic_weight) * unit * unit,
          {-1.0 * outward, outward}};
}

Summand<3> ShapeGuard::corner_summand(std::size_t c, const std::vector<Vec3>& x) const {
  const std::array<Index, 3> stencil = corner(c);
  if (corner_value(c, x) == 0.0) return {stencil};
  const auto [own, next, last] = stencil;
  const Vec3 at = x[own], u = x[next] - at, w = x[last] - at;
  const Vec3 normal = cross(u, w);
  const double size = norm(normal);
  if (!(size > 0.0)) return {stencil};
  const Bound& bound = bounds_[corner_bounds_[c]];
  const double unit = 1.0 / bound.range;
  const double q = (bound.sharp - math::atan2(size, dot(u, w))) * unit,
               sixth = q * q * q * q * q * q;
  const Vec3 by_first = (-1.0 / (dot(u, u) * size)) * cross(normal, u);
  const Vec3 by_second = (1.0 / (dot(w, w) * size)) * cross(normal, w);
  return {stencil,
          -(2.0 * k_corner_quadratic_weight + 8.0 * k_corner_octic_weight * sixth) * q * unit,
          (2.0 * k_corner_quadratic_weight + 56.0 * k_corner_octic_weight * sixth) * unit * unit,
          {-1.0 * by_first - by_second, by_first, by_second}};
}

}  // namespace planish
