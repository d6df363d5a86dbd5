#pragma once

#include <array>
#include <cmath>
#include <cstdint>

namespace planish {

/// Number of a vertex or a triangle, counted from 0.
using Index = std::uint32_t;

/// A place or a vector in the plane, with sums, differences and multiples.
struct Vec2 {
  double x = 0.0, y = 0.0;  ///< Cartesian coordinate

  friend constexpr Vec2 operator+(Vec2 a, Vec2 b) { return {a.x + b.x, a.y + b.y}; }
  friend constexpr Vec2 operator-(Vec2 a, Vec2 b) { return {a.x - b.x, a.y - b.y}; }
  friend constexpr Vec2 operator*(double s, Vec2 a) { return {s * a.x, s * a.y}; }
  friend constexpr bool operator==(const Vec2&, const Vec2&) = default;
};

/// A place or a vector in space, with sums, differences and multiples.
struct Vec3 {
  double x = 0.0, y = 0.0, z = 0.0;  ///< Cartesian coordinate

  /// Adds b, coordinate by coordinate.
  constexpr Vec3& operator+=(Vec3 b) { return x += b.x, y += b.y, z += b.z, *this; }
  friend constexpr Vec3 operator+(Vec3 a, Vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend constexpr Vec3 operator-(Vec3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend constexpr Vec3 operator-(Vec3 a) { return {-a.x, -a.y, -a.z}; }
  friend constexpr Vec3 operator*(double s, Vec3 a) { return {s * a.x, s * a.y, s * a.z}; }
  friend constexpr bool operator==(const Vec3&, const Vec3&) = default;
};

/// The scalar product.
constexpr double dot(Vec2 a, Vec2 b) {
  return a.x * b.x + a.y * b.y;
}
/// The scalar product.
constexpr double dot(Vec3 a, Vec3 b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
/// Twice the signed area of the triangle 0, a, b.
constexpr double cross(Vec2 a, Vec2 b) {
  return a.x * b.y - a.y * b.x;
}
/// The vector product: normal to a and b, as long as the area that they span.
constexpr Vec3 cross(Vec3 a, Vec3 b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
/// The length of a vector.
inline double norm(Vec2 a) {
  return std::sqrt(dot(a, a));
}
/// The length of a vector.
inline double norm(Vec3 a) {
  return std::sqrt(dot(a, a));
}

}  // namespace planish
