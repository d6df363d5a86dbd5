#include "mesh/symmetry/mirror_fit.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <planish/mesh/symmetry.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include "core/neumaier_sum.h"
#include "mesh/symmetry/moments.h"

namespace planish {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

Vector3d as_eigen(Vec3 p) {
  return {p.x, p.y, p.z};
}

Vec3 mean_of(std::span<const Vec3> points) {
  Vec3 sum;
  for (const Vec3 p : points)
    sum += p;
  return 1.0 / static_cast<double>(points.size()) * sum;
}

Plane across(Vec3 normal, Vec3 through) {
  const Vec3 unit = 1.0 / norm(normal) * normal;
  return {unit, dot(unit, through)};
}

/// Two directions at right angles to a unit normal and to each other.
std::array<Vec3, 2> along_plane(Vec3 normal) {
  const Vec3 axis = std::abs(normal.x) < 0.6 ? Vec3{1.0, 0.0, 0.0} : Vec3{0.0, 1.0, 0.0};
  const Vec3 u = cross(normal, axis), unit = 1.0 / norm(u) * u;
  return {unit, cross(normal, unit)};
}

/// The solution of least size: of a sphere every turn of the plane is as good.
Vector3d least_solution(const Matrix3d& matrix, const Vector3d& right) {
  constexpr double k_none = 1e-9;  // of the largest eigenvalue
  const Eigen::SelfAdjointEigenSolver<Matrix3d> solver(matrix);
  Vector3d solution = Vector3d::Zero();
  for (int k = 0; k < 3; ++k) {
    const double value = solver.eigenvalues()[k];
    if (!(value > k_none * solver.eigenvalues()[2])) continue;
    const Vector3d direction = solver.eigenvectors().col(k);
    solution += direction.dot(right) / value * direction;
  }
  return solution;
}

}  // namespace

// Shares of triangles follow the sequence R2 of M. Roberts (2018), which fills a square evenly.
std::vector<Vec3> even_places(const TriMesh& mesh, std::size_t count) {
  std::vector<double> until;
  double area = 0.0;
  until.reserve(mesh.triangles.size());
  for (const Triangle& t : mesh.triangles) {
    const Vec3 a = mesh.positions[t[0]];
    area += norm(cross(mesh.positions[t[1]] - a, mesh.positions[t[2]] - a));
    until.push_back(area);
  }
  std::vector<Vec3> places;
  places.reserve(count);
  double whole = 0.0;
  for (std::size_t k = 0; k < count; ++k) {
    const auto number = static_cast<double>(k);
    const double at = (number + 0.5) / static_cast<double>(count) * area;
    const auto found = std::lower_bound(until.begin(), until.end() - 1, at) - until.begin();
    const Triangle& t = mesh.triangles[static_cast<std::size_t>(found)];
    double u = std::modf(0.7548776662466927 * (number + 1.0), &whole);
    double v = std::modf(0.5698402909980532 * (number + 1.0), &whole);
    if (u + v > 1.0) u = 1.0 - u, v = 1.0 - v;
    const Vec3 a = mesh.positions[t[0]];
    places.push_back(a + (u * (mesh.positions[t[1]] - a) + v * (mesh.positions[t[2]] - a)));
  }
  return places;
}

std::vector<Vec3> even_border_places(const Patch& patch, std::span<const Vec3> positions,
                                     std::size_t count) {
  std::vector<std::array<Vec3, 2>> edges;
  double length = 0.0;
  for (const std::vector<Index>& loop : patch.border_loops()) {
    for (std::size_t k = 0; k < loop.size(); ++k) {
      edges.push_back({positions[loop[k]], positions[loop[(k + 1) % loop.size()]]});
      length += norm(edges.back()[1] - edges.back()[0]);
    }
  }
  std::vector<Vec3> places;
  if (edges.empty()) return places;
  places.reserve(count);
  double until = 0.0;
  for (const auto& [from, to] : edges) {
    const double own = norm(to - from);
    for (;;) {
      const double at = static_cast<double>(places.size()) / static_cast<double>(count) * length;
      if (!(at < until + own)) break;
      places.push_back(from + (at - until) / own * (to - from));
    }
    until += own;
  }
  return places;
}

// With H = I - 2 n n^T, p and c from their means, sum |H p - c|^2 = const + 4 n^T (sum p c^T) n.
Plane plane_between(std::span<const Vec3> places, std::span<const Vec3> partners,
                    const Plane& near) {
  const Vec3 place = mean_of(places), partner = mean_of(partners);
  Matrix3d sum = Matrix3d::Zero();
  for (std::size_t i = 0; i < places.size(); ++i)
    sum += as_eigen(places[i] - place) * as_eigen(partners[i] - partner).transpose();
  const Vector3d n = principal_axes(0.5 * (sum + sum.transpose())).col(0);
  Vec3 normal{n[0], n[1], n[2]};
  if (dot(normal, near.normal) < 0.0) normal = -normal;
  return across(normal, 0.5 * (place + partner));
}

MirrorFitting::Pairs MirrorFitting::pairs_of(const Plane& plane) const {
  Pairs pairs;
  NeumaierSum squares;
  pairs.mirrored.reserve(places_.size());
  pairs.closest.reserve(places_.size());
  for (const Vec3 p : places_) {
    pairs.mirrored.push_back(mirrored(plane, p));
    pairs.closest.push_back(surface_.query(pairs.mirrored.back()));
    squares.add(pairs.closest.back().squared_distance);
  }
  pairs.rms = std::sqrt(squares.value() / static_cast<double>(places_.size()));
  return pairs;
}

Plane MirrorFitting::moved_to_closest(const Plane& plane, const Pairs& pairs) const {
  std::vector<Vec3> partners;
  partners.reserve(pairs.closest.size());
  for (const ClosestPoint& closest : pairs.closest)
    partners.push_back(closest.point);
  return plane_between(places_, partners, plane);
}

// A mirrored place q = p - 2 h n, h = n . (p - middle) - d, is at the distance m . (q - c) from the
// surface. Of a turn of n by u and w and a shift e of d, dq = -2 ((dn . (p - middle) - e) n + h
// dn).
Plane MirrorFitting::newton_step(const Plane& plane, const Pairs& pairs) const {
  constexpr double k_apart = 1e-14;
  const auto [u, w] = along_plane(plane.normal);
  const double offset = plane.offset - dot(plane.normal, middle_);
  Matrix3d matrix = Matrix3d::Zero();
  Vector3d right = Vector3d::Zero();
  for (std::size_t i = 0; i < places_.size(); ++i) {
    const Vec3 p = places_[i] - middle_;
    const ClosestPoint& closest = pairs.closest[i];
    const Vec3 gap = pairs.mirrored[i] - closest.point;
    const bool is_inside = std::none_of(closest.barycentric.begin(), closest.barycentric.end(),
                                        [](double share) { return share == 0.0; });
    Vec3 across_surface = normals_[closest.triangle];
    if (!is_inside && norm(gap) > k_apart) across_surface = 1.0 / norm(gap) * gap;
    const double height = dot(plane.normal, p) - offset, along = dot(across_surface, plane.normal);
    const auto turned = [&](Vec3 d) {
      return -2.0 * (dot(d, p) * along + height * dot(across_surface, d));
    };
    const Vector3d row(turned(u), turned(w), 2.0 * along);
    matrix += row * row.transpose();
    right -= dot(across_surface, gap) * row;
  }
  const Vector3d step = least_solution(matrix, right);
  const Vec3 normal = plane.normal + (step[0] * u + step[1] * w);
  const double length = norm(normal);
  const Vec3 unit = 1.0 / length * normal;
  return {unit, (offset + step[2]) / length + dot(unit, middle_)};
}

MirrorFit MirrorFitting::fit_of(const Plane& plane) const {
  return {plane, pairs_of(plane).rms};
}

MirrorFit MirrorFitting::refined(const Plane& plane, int rounds, int newton_steps) const {
  constexpr double k_gain = 1.0 - 1e-6;
  Plane now = plane;
  Pairs pairs = pairs_of(now);
  const auto try_step = [&](const Plane& next) {
    Pairs there = pairs_of(next);
    if (!(there.rms < k_gain * pairs.rms)) return false;
    now = next;
    pairs = std::move(there);
    return true;
  };
  for (int k = 0; k < rounds && try_step(moved_to_closest(now, pairs)); ++k) {
  }
  for (int k = 0; k < newton_steps && try_step(newton_step(now, pairs)); ++k) {
  }
  return {now, pairs.rms};
}

}  // namespace planish
