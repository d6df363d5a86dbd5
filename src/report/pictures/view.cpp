#include "report/pictures/view.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <Eigen/Geometry>

#include "core/math.h"
#include "mesh/symmetry/moments.h"

namespace planish {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// How much the eye is lifted from the mean normal, per unit along it: for a plane, and what is
// added for a patch that is as high as it is wide.
constexpr double k_tilt = 0.35, k_tilt_of_height = 0.9;

// The way that counts as positive must not hang on the solver.
Vector3d with_largest_part_positive(const Vector3d& direction) {
  Eigen::Index largest = 0;
  direction.cwiseAbs().maxCoeff(&largest);
  return direction[largest] < 0.0 ? Vector3d(-direction) : direction;
}

Vec3 to_vec(const Vector3d& v) {
  return {v.x(), v.y(), v.z()};
}

/// The corners of the triangles in the plane of two directions.
std::vector<Vec2> seen_along(const TriMesh& mesh, Vec3 right, Vec3 up) {
  const double scale = unit_scale(mesh);
  std::vector<bool> used(mesh.positions.size(), false);
  std::vector<Vec2> places;
  places.reserve(mesh.positions.size());
  for (const Triangle& triangle : mesh.triangles) {
    for (const Index v : triangle) {
      if (used[v]) continue;
      used[v] = true;
      const Vec3 p = scale * mesh.positions[v];
      places.push_back({dot(right, p), dot(up, p)});
    }
  }
  return places;
}

/// Of the rectangle around them whose sides lie at this angle, radians.
Vec2 rectangle_around(const std::vector<Vec2>& places, double angle) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const double c = math::cos(angle), s = math::sin(angle);
  Vec2 low = {infinity, infinity}, high = {-infinity, -infinity};
  for (const Vec2 p : places) {
    const double x = c * p.x + s * p.y, y = c * p.y - s * p.x;
    low = {std::min(low.x, x), std::min(low.y, y)};
    high = {std::max(high.x, x), std::max(high.y, y)};
  }
  return high - low;
}

/// The angle at which the smallest rectangle around them has its longer side, radians: so they fill
/// an upright picture. 0 where nothing else is better.
double level_angle(const std::vector<Vec2>& places) {
  constexpr double degree = std::numbers::pi / 180.0;
  double best = 0.0;
  Vec2 size = rectangle_around(places, best);
  const auto try_angle = [&](double angle) {
    const Vec2 some = rectangle_around(places, angle);
    if (!(some.x * some.y < 0.9999 * size.x * size.y)) return;
    size = some;
    best = angle;
  };
  for (int step = 1; step < 45; ++step)
    try_angle(2.0 * step * degree);
  const double middle = best;
  for (int step = -20; step <= 20; ++step)
    try_angle(middle + 0.1 * step * degree);
  return size.x >= size.y ? best : best + 90.0 * degree;
}

}  // namespace

View view_of(const TriMesh& mesh) {
  const SurfaceMoments moments = moments_of(mesh.triangles, mesh.positions, unit_scale(mesh));
  Vector3d normal = with_largest_part_positive(principal_axes(moments.covariance).col(0));
  if (moments.normal.norm() > 1e-3 * moments.area) normal = moments.normal.normalized();
  const Matrix3d flat = Matrix3d::Identity() - normal * normal.transpose();
  const Vector3d longest = principal_axes(flat * moments.covariance * flat).col(2);
  const Vector3d beside = normal.cross(longest);
  const double angle = level_angle(seen_along(mesh, to_vec(longest), to_vec(beside)));
  const Vector3d right =
      with_largest_part_positive(math::cos(angle) * longest + math::sin(angle) * beside);
  const Vector3d across = normal.cross(right);
  const auto spread = [&](const Vector3d& direction) {
    return std::sqrt(std::max(0.0, direction.dot(moments.covariance * direction)));
  };
  const double width = spread(across);
  const double height = width > 0.0 ? std::min(1.0, spread(normal) / width) : 0.0;
  const Vector3d towards = (normal - (k_tilt + k_tilt_of_height * height) * across).normalized();
  return {to_vec(right), to_vec(towards.cross(right)), to_vec(towards)};
}

View standing_view(UpAxis up) {
  constexpr double degree = std::numbers::pi / 180.0, turn = 28.0 * degree, lift = 22.0 * degree;
  const auto axes = [up](Vec3 v) { return up == UpAxis::y ? v : Vec3{v.x, -v.z, v.y}; };
  const double level = math::cos(lift);
  const Vec3 towards = {level * math::sin(turn), math::sin(lift), level * math::cos(turn)};
  const Vec3 right = {math::cos(turn), 0.0, -math::sin(turn)};
  return {axes(right), axes(cross(towards, right)), axes(towards)};
}

}  // namespace planish
