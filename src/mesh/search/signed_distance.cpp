#include "mesh/search/signed_distance.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <planish/core/error.h>
#include <planish/mesh/inspect.h>

#include "geometry/angle_between.h"

namespace planish {

namespace {

Vec3 unit(Vec3 a) {
  const double length = norm(a);
  return length > 0.0 ? (1.0 / length) * a : a;
}

/// Six times the volume that the surface bounds, in units where it is about 1 large.
double volume_of(const TriMesh& surface) {
  const double scale = unit_scale(surface);
  const Vec3 base = scale * surface.positions[surface.triangles[0][0]];
  double volume = 0.0;
  for (const Triangle& t : surface.triangles) {
    const auto at = [&](int k) { return scale * surface.positions[t[k]] - base; };
    volume += dot(at(0), cross(at(1), at(2)));
  }
  return volume;
}

/// A side of a triangle by its vertices, to find the other triangle at it.
struct Side {
  std::pair<Index, Index> ends;  // the smaller number first
  Index triangle;
  int k;
  friend bool operator<(const Side& a, const Side& b) { return a.ends < b.ends; }
};

std::vector<Side> sorted_sides(const std::vector<Triangle>& triangles) {
  std::vector<Side> sides;
  sides.reserve(3 * triangles.size());
  for (Index t = 0; t < triangles.size(); ++t) {
    for (int k = 0; k < 3; ++k) {
      const auto ends = std::minmax({triangles[t][k], triangles[t][(k + 1) % 3]});
      sides.push_back({ends, t, k});
    }
  }
  std::stable_sort(sides.begin(), sides.end());
  return sides;
}

}  // namespace

SignedDistance::SignedDistance(const TriMesh& surface)
    : tree_(surface),
      triangles_(surface.triangles),
      of_side_(triangles_.size()),
      of_vertex_(surface.positions.size()) {
  double largest = 0.0;
  for (const Vec3 p : surface.positions)
    largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  rounding_ = 1e-10 * largest;
  of_triangle_.reserve(triangles_.size());
  for (const Triangle& t : triangles_) {
    const auto edge = [&](int k, int l) {
      return surface.positions[t[l % 3]] - surface.positions[t[k]];
    };
    const Vec3 normal = unit(cross(edge(0, 1), edge(0, 2)));
    of_triangle_.push_back(normal);
    for (int k = 0; k < 3; ++k) {
      const Vec3 a = edge(k, k + 1), b = edge(k, k + 2);
      of_vertex_[t[k]] += angle_between(a, b) * normal;
    }
  }
  const std::vector<Side> sides = sorted_sides(triangles_);
  for (std::size_t i = 0; i + 1 < sides.size(); i += 2) {
    const Side &a = sides[i], &b = sides[i + 1];
    of_side_[a.triangle][a.k] = of_side_[b.triangle][b.k] =
        of_triangle_[a.triangle] + of_triangle_[b.triangle];
  }
}

Vec3 SignedDistance::normal_at(const ClosestPoint& closest) const {
  const auto& share = closest.barycentric;
  const auto zeros = std::count(share.begin(), share.end(), 0.0);
  if (zeros == 0) return of_triangle_[closest.triangle];
  for (std::size_t k = 0; k < 3; ++k) {
    if (zeros == 2 && share[k] != 0.0) return of_vertex_[triangles_[closest.triangle][k]];
    // The side from corner k ends where the one of share 0 begins to be away from it.
    if (zeros == 1 && share[(k + 2) % 3] == 0.0) return of_side_[closest.triangle][k];
  }
  return of_triangle_[closest.triangle];
}

Distance SignedDistance::at(Vec3 p) const {
  const ClosestPoint closest = tree_.query(p);
  const Vec3 normal = normal_at(closest), offset = p - closest.point;
  const double size = std::sqrt(closest.squared_distance);
  const double sign = dot(offset, normal) < 0.0 ? -1.0 : 1.0;
  if (size <= rounding_) return {sign * size, unit(normal)};
  return {sign * size, (sign / size) * offset};
}

void require_closed(const TriMesh& surface, std::string_view what) {
  const auto refuse = [&](ErrorCode code, const std::string& message, std::size_t first,
                          std::size_t count) {
    throw Error(code, std::string(what) + ": " + message,
                {.path = {}, .first = first, .count = count});
  };
  const Inspection inspection = inspect(surface);
  if (const auto problem = blocking_problem(inspection, Purpose::measure))
    refuse(problem->code, problem->message, problem->first, problem->count);
  for (const Problem& problem : inspection.problems) {
    if (problem.code == ErrorCode::zero_area)
      refuse(problem.code, problem.message, problem.first, problem.count);
  }
  const std::size_t holes = inspection.topology.border_loops;
  if (holes > 0) {
    refuse(ErrorCode::open_surface,
           "it has " + std::to_string(holes) + (holes == 1 ? " border loop" : " border loops") +
               ", so it has no inside; close its holes",
           0, holes);
  }
  if (!(volume_of(surface) > 0.0)) {
    refuse(ErrorCode::inconsistent_orientation,
           "its triangles are oriented inwards; turn them all around", 0, surface.triangles.size());
  }
}

}  // namespace planish
