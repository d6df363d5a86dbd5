#pragma once

// Numbers that depend on a step t, developed to the third power of t: what derivatives along a line
// must agree with.

#include <array>
#include <cmath>
#include <cstddef>

#include <planish/core/vec.h>

namespace planish::plain {

struct Series {
  static constexpr std::size_t k_terms = 4;
  std::array<double, k_terms> c{};  // by powers of t
};

inline Series operator+(Series a, const Series& b) {
  for (std::size_t k = 0; k < Series::k_terms; ++k)
    a.c[k] += b.c[k];
  return a;
}
inline Series operator-(Series a, const Series& b) {
  for (std::size_t k = 0; k < Series::k_terms; ++k)
    a.c[k] -= b.c[k];
  return a;
}
inline Series operator*(const Series& a, const Series& b) {
  Series product;
  for (std::size_t k = 0; k < Series::k_terms; ++k) {
    for (std::size_t i = 0; i <= k; ++i)
      product.c[k] += a.c[i] * b.c[k - i];
  }
  return product;
}
inline Series operator/(const Series& a, const Series& b) {
  Series quotient;
  for (std::size_t k = 0; k < Series::k_terms; ++k) {
    double rest = a.c[k];
    for (std::size_t i = 1; i <= k; ++i)
      rest -= b.c[i] * quotient.c[k - i];
    quotient.c[k] = rest / b.c[0];
  }
  return quotient;
}
inline Series sqrt(const Series& a) {
  Series root;
  root.c[0] = std::sqrt(a.c[0]);
  for (std::size_t k = 1; k < Series::k_terms; ++k) {
    double rest = a.c[k];
    for (std::size_t i = 1; i < k; ++i)
      rest -= root.c[i] * root.c[k - i];
    root.c[k] = rest / (2.0 * root.c[0]);
  }
  return root;
}
inline Series derivative(const Series& a) {
  Series d;
  for (std::size_t k = 1; k < Series::k_terms; ++k)
    d.c[k - 1] = static_cast<double>(k) * a.c[k];
  return d;
}
/// Its derivative is (x y' - y x') / (x^2 + y^2).
inline Series atan2(const Series& y, const Series& x) {
  const Series rate = (x * derivative(y) - y * derivative(x)) / (x * x + y * y);
  Series angle;
  angle.c[0] = std::atan2(y.c[0], x.c[0]);
  for (std::size_t k = 1; k < Series::k_terms; ++k)
    angle.c[k] = rate.c[k - 1] / static_cast<double>(k);
  return angle;
}

/// A place on the line p + t d.
struct SeriesPoint {
  Series x, y, z;
};
inline SeriesPoint on_line(Vec3 p, Vec3 d) {
  return {{{p.x, d.x}}, {{p.y, d.y}}, {{p.z, d.z}}};
}
inline SeriesPoint operator-(const SeriesPoint& a, const SeriesPoint& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Series dot(const SeriesPoint& a, const SeriesPoint& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline SeriesPoint cross(const SeriesPoint& a, const SeriesPoint& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline Series angle_between(const SeriesPoint& a, const SeriesPoint& b) {
  const SeriesPoint normal = cross(a, b);
  return atan2(sqrt(dot(normal, normal)), dot(a, b));
}

}  // namespace planish::plain
