#include "mesh/polygon/own_plane.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace planish {

namespace {

/// Of the square of the extent: what rounding leaves of an area that is 0, of corners that are no
/// farther from the origin than the extent.
constexpr double k_no_area = 1e-14;
/// Rounded to whole steps of that unit, differences of places are exact.
constexpr double k_steps = 562949953421312.0;  // 2^49

double largest_coordinate(Vec3 p) {
  return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
}

/// The largest power of two that is no more than a number: dividing by it loses no digit.
double power_of_two_below(double x) {
  constexpr std::uint64_t k_exponent = 0x7ff0000000000000;
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) & k_exponent);
}

/// The axis that is farthest from the direction of a vector.
Vec3 axis_across(Vec3 a) {
  const double x = std::abs(a.x), y = std::abs(a.y), z = std::abs(a.z);
  if (x <= y && x <= z) return {1.0, 0.0, 0.0};
  return y <= z ? Vec3{0.0, 1.0, 0.0} : Vec3{0.0, 0.0, 1.0};
}

}  // namespace

OwnPlane::OwnPlane(std::span<const Vec3> corners) : half_first_(0.5 * corners.front()) {
  for (const Vec3 p : corners)
    extent_ = std::max(extent_, largest_coordinate(0.5 * p - half_first_));
  extent_ = power_of_two_below(extent_);
  if (extent_ == 0.0) {
    shape_ = Shape::line;
    return;
  }
  Vec3 area;
  Vec3 before = unit_sized(corners[1]);
  for (const Vec3 p : corners.subspan(2)) {
    const Vec3 after = unit_sized(p);
    area += cross(before, after);
    before = after;
  }
  const double size = norm(area);
  double far = extent_;
  for (const Vec3 p : corners)
    far = std::max(far, largest_coordinate(p));
  const double no_area = k_no_area * (far / extent_);
  if (size <= no_area) {
    shape_ = are_on_a_line(corners, no_area) ? Shape::line : Shape::none;
    return;
  }
  const Vec3 normal = (1.0 / size) * area;
  const Vec3 across = cross(axis_across(normal), normal);
  right_ = (1.0 / norm(across)) * across;
  up_ = cross(normal, right_);
}

Vec2 OwnPlane::place(Vec3 corner) const {
  const Vec3 p = unit_sized(corner);
  return {std::round(k_steps * dot(p, right_)), std::round(k_steps * dot(p, up_))};
}

Vec3 OwnPlane::unit_sized(Vec3 corner) const {
  // Halves: a difference may be too large for a double.
  const Vec3 half = 0.5 * corner - half_first_;
  return {half.x / extent_, half.y / extent_, half.z / extent_};
}

bool OwnPlane::are_on_a_line(std::span<const Vec3> corners, double no_area) const {
  Vec3 end;
  for (const Vec3 p : corners) {
    const Vec3 place = unit_sized(p);
    if (dot(place, place) > dot(end, end)) end = place;
  }
  return std::all_of(corners.begin(), corners.end(),
                     [&](Vec3 p) { return norm(cross(end, unit_sized(p))) <= no_area; });
}

}  // namespace planish
