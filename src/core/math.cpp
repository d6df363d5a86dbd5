#include "core/math.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

#include "core/arctangent_terms.h"

namespace planish::math {

namespace {

constexpr double k_nan = std::numeric_limits<double>::quiet_NaN();
constexpr double k_infinity = std::numeric_limits<double>::infinity();
constexpr double k_pi = 3.14159265358979323846;
constexpr double k_pi_rest = 1.2246467991473532e-16;  // pi is k_pi plus this, to 32 digits

/// The polynomial with these coefficients, the constant first, by Horner's rule.
template <std::size_t n>
double polynomial(const std::array<double, n>& terms, double x) {
  double sum = terms[n - 1];
  for (std::size_t k = n - 1; k-- > 0;)
    sum = sum * x + terms[k];
  return sum;
}

/// The integer next to x, |x| < 2^51, without a call: what is added leaves no digit after the
/// point.
double nearest_integer(double x) {
  constexpr double shift = 6755399441055744.0;  // 1.5 * 2^52
  return (x + shift) - shift;
}

/// An angle as a number of quarter turns and the rest of at most pi / 4, which is in two parts.
struct Reduced {
  int quarter;
  double angle, rest;
};

/// pi / 2 in three parts. The first two have 33 digits of two, so that their products with numbers
/// of quarter turns below 2^20 are exact (Cody and Waite 1980).
Reduced reduced(double x) {
  constexpr double part_1 = 0x1.921fb544p+0, part_2 = 0x1.0b4611a6p-34,
                   part_3 = 0x1.3198a2e037073p-69;
  const double n = nearest_integer(x * (2.0 / k_pi));
  const double far = x - n * part_1, step = n * part_2;
  const double near = far - step;
  const double lost = ((far - near) - step) - n * part_3;
  const double angle = near + lost;
  return {static_cast<int>(static_cast<long long>(n) & 3), angle, (near - angle) + lost};
}

/// Taylor's series: what is left out is below 1e-19 for |x| <= pi / 4.
double short_sine(double x, double rest) {
  constexpr std::array terms{
      -1.0 / 6,        1.0 / 120,        -1.0 / 5040,          1.0 / 362880,
      -1.0 / 39916800, 1.0 / 6227020800, -1.0 / 1307674368000, 1.0 / 355687428096000};
  const double square = x * x;
  return x + (x * square * polynomial(terms, square) + rest * (1.0 - 0.5 * square));
}

double short_cosine(double x, double rest) {
  constexpr std::array terms{
      1.0 / 24,        -1.0 / 720,         1.0 / 40320,         -1.0 / 3628800,
      1.0 / 479001600, -1.0 / 87178291200, 1.0 / 20922789888000};
  const double square = x * x, half = 0.5 * square;
  const double near = 1.0 - half;
  // The digits that 1 - half loses come back.
  return near + (((1.0 - near) - half) + (square * square * polynomial(terms, square) - x * rest));
}

/// arctan(t), |t| <= tan(pi / 8).
double short_arctangent(double t) {
  const double s = t * t, s2 = s * s;
  const auto& c = k_arctangent_terms;
  // Even and odd terms by themselves, which takes half the time.
  const double even = c[2] + s2 * (c[4] + s2 * (c[6] + s2 * (c[8] + s2 * c[10])));
  const double odd = c[1] + s2 * (c[3] + s2 * (c[5] + s2 * (c[7] + s2 * c[9])));
  return t + t * (s2 * even + s * odd);
}

/// A power of two that brings a number of that size near 1, so that squares are safe.
double safe_scale(double size) {
  constexpr double large = 0x1p+500, small = 0x1p-500;
  if (size > large) return 0x1p-600;
  if (size < small) return 0x1p+600;
  return 1.0;
}

}  // namespace

SineCosine sincos(double x) {
  constexpr double most = 1e6;
  if (!(std::abs(x) <= most)) return {k_nan, k_nan};
  if (std::abs(x) < 1e-150) return {x, 1.0};
  const Reduced r = reduced(x);
  const double s = short_sine(r.angle, r.rest), c = short_cosine(r.angle, r.rest);
  switch (r.quarter) {
    case 0:
      return {s, c};
    case 1:
      return {c, -s};
    case 2:
      return {-s, -c};
    default:
      return {-c, s};
  }
}

double sin(double x) {
  return sincos(x).sine;
}

double cos(double x) {
  return sincos(x).cosine;
}

double tan(double x) {
  const auto [sine, cosine] = sincos(x);
  return sine / cosine;
}

double asin(double x) {
  return atan2(x, std::sqrt((1.0 - x) * (1.0 + x)));
}

double acos(double x) {
  return 2.0 * atan2(std::sqrt(1.0 - x), std::sqrt(1.0 + x));
}

double atan2(double y, double x) {
  const double a = std::abs(x), b = std::abs(y);
  if (!(a <= k_infinity && b <= k_infinity)) return k_nan;
  const double large = std::max(a, b), small = std::min(a, b);
  double angle = 0.0, rest = 0.0;
  if (large == k_infinity) {
    if (small == k_infinity) angle = 0.25 * k_pi;
  } else if (small > 0.0) {
    // Up to pi / 8 as it is, beyond as pi / 4 plus what is left.
    const bool beyond = small > k_tan_eighth * large;
    const double unit = large > 0x1p+1000 ? 0.5 : 1.0;  // sums must not overflow
    const double t =
        beyond ? (unit * small - unit * large) / (unit * small + unit * large) : small / large;
    angle = short_arctangent(t);
    if (beyond) {
      rest = angle + 0.25 * k_pi_rest;
      angle = 0.25 * k_pi + rest;
      rest -= angle - 0.25 * k_pi;
    }
  }
  if (b > a) angle = 0.5 * k_pi - (angle - (0.5 * k_pi_rest - rest)), rest = 0.0;
  if (std::signbit(x)) angle = k_pi - (angle - (k_pi_rest - rest));
  return std::copysign(angle, y);
}

double exp(double x) {
  constexpr double most = 709.782712893384, least = -690.0;
  constexpr double ln2_high = 0x1.62e42feep-1, ln2_low = 0x1.a39ef35793c76p-33;
  if (std::isnan(x)) return x;
  if (x > most) return k_infinity;
  if (x < least) return 0.0;
  const double n = nearest_integer(x * (1.0 / (ln2_high + ln2_low)));
  const double high = x - n * ln2_high, low = n * ln2_low;
  const double r = high - low, rest = (high - r) - low;
  // Taylor's series from r^2 / 2 on: what is left out is below 1e-17 for |r| <= log(2) / 2.
  constexpr std::array terms{1.0 / 2,       1.0 / 6,        1.0 / 24,        1.0 / 120,
                             1.0 / 720,     1.0 / 5040,     1.0 / 40320,     1.0 / 362880,
                             1.0 / 3628800, 1.0 / 39916800, 1.0 / 479001600, 1.0 / 6227020800};
  return std::ldexp(1.0 + (r + (r * r * polynomial(terms, r) + rest)), static_cast<int>(n));
}

double log(double x) {
  if (!(x > 0.0)) return x == 0.0 ? -k_infinity : k_nan;
  if (x == k_infinity) return x;
  constexpr double ln2_high = 0x1.62e42feep-1, ln2_low = 0x1.a39ef35793c76p-33;
  int exponent = 0;
  double m = std::frexp(x, &exponent);  // 1/2 to 1
  if (m < 0.7071067811865476) m *= 2.0, --exponent;
  // log(1 + f) = f - f^2/2 + s (f^2/2 + sum of 2 s^2k / (2k + 1)), s = f / (2 + f): of the series
  // of 2 artanh(s), the parts that are large are exact or nearly so.
  const double f = m - 1.0, s = f / (2.0 + f), square = s * s, half = 0.5 * f * f;
  constexpr std::array terms{2.0 / 3,  2.0 / 5,  2.0 / 7,  2.0 / 9,  2.0 / 11,
                             2.0 / 13, 2.0 / 15, 2.0 / 17, 2.0 / 19, 2.0 / 21};
  const double series = square * polynomial(terms, square);
  const double n = exponent;
  return n * ln2_high - ((half - (s * (half + series) + n * ln2_low)) - f);
}

double log10(double x) {
  constexpr double log10_e = 0.4342944819032518;
  const double value = log10_e * log(x);
  const double whole = std::abs(value) < 400.0 ? nearest_integer(value) : 0.5;
  return power_of_ten(static_cast<int>(whole)) == x ? whole : value;
}

double pow(double x, double y) {
  if (y == 0.0) return 1.0;
  if (x == 0.0) return y > 0.0 ? 0.0 : k_infinity;
  return exp(y * log(x));
}

double power_of_ten(int n) {
  constexpr int exact = 22;
  constexpr double largest = 1e22;
  double power = 1.0;
  int left = std::abs(n);
  for (; left > exact; left -= exact)
    power *= largest;
  double rest = 1.0;
  for (; left > 0; --left)
    rest *= 10.0;
  power *= rest;
  return n < 0 ? 1.0 / power : power;
}

double hypot(double x, double y) {
  return hypot(x, y, 0.0);
}

double hypot(double x, double y, double z) {
  const double size = std::max({std::abs(x), std::abs(y), std::abs(z)});
  const double scale = safe_scale(size), a = scale * x, b = scale * y, c = scale * z;
  return std::sqrt(a * a + b * b + c * c) / scale;
}

}  // namespace planish::math
