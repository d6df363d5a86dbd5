#pragma once

#include "core/arctangent_terms.h"
#include "core/simd/simd.h"

namespace planish::PLANISH_ISA {

constexpr double k_pi = 3.14159265358979323846;

/// A complex number whose argument is an angle.
struct Complex {
  Real re, im;
};

inline Complex operator*(const Complex& a, const Complex& b) {
  return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}

/// arctan(t) for |t| <= tan(pi / 8).
inline Real short_arctangent(Real t) {
  const Real s = t * t;
  Real sum = broadcast(k_arctangent_terms[10]);
  for (int k = 9; k >= 0; --k)
    sum = sum * s + k_arctangent_terms[k];
  return t * sum;
}

/// Where short_argument() holds.
inline Mask is_short(const Complex& z) {
  return absolute(z.im) <= k_tan_eighth * z.re;
}

/// The same, and z is not so small that it may have lost digits.
inline Mask is_short_and_exact(const Complex& z) {
  constexpr double least = 1e-290;
  return absolute(z.im) + least <= k_tan_eighth * z.re;
}

/// The argument of z where is_short(z), anything elsewhere.
inline Real short_argument(const Complex& z) {
  return short_arctangent(z.im / z.re);
}

/// The argument of any z, -pi to pi; NaN of 0 and of NaN.
inline Real argument(const Complex& z) {
  const Real a = absolute(z.re), b = absolute(z.im);
  const Real large = max(a, b), small = min(a, b);
  // Up to pi / 8 as it is, beyond as pi / 4 plus the rest.
  const Mask beyond = small > k_tan_eighth * large;
  const Real t = select(beyond, small - large, small) / select(beyond, small + large, large);
  Real angle = select(beyond, broadcast(0.25 * k_pi), Real{}) + short_arctangent(t);
  angle = select(b > a, 0.5 * k_pi - angle, angle);
  angle = select(z.re < 0.0, k_pi - angle, angle);
  return select(z.im < 0.0, -angle, angle);
}

/// The corner at a size near 1, whatever the size of the triangle; no angle where it has none.
inline Complex near_one(const Complex& corner) {
  const Real size = max(absolute(corner.re), absolute(corner.im));
  const Real factor = exponent_off(size);
  return {select(size > 0.0, factor * corner.re, broadcast(1.0)), factor * corner.im};
}

/// Sums of angles of 0 to pi, as a product of corners and a count of full turns. Angles add where
/// complex numbers multiply, and no digits are lost near 2 pi.
class AngleSum {
 public:
  void add(const Complex& corner) {
    product_ = product_ * corner;
    // Only a step from the lower half, from pi on, to the upper one ends a turn, as no angle is
    // above pi.
    const Bits lower = (Bits)select(product_.im == 0.0, product_.re, product_.im) >> 63;
    turns_ -= was_lower_ & ~lower;
    was_lower_ = lower;
    // The product of a few corners is far from overflow and underflow.
    if (++factors_ % 4 == 0) shrink();
  }

  /// True where the corners were so small that digits were lost; then near_one() helps.
  Mask is_lost() const { return min(smallest_, size()) < 1e-200; }

  /// 2 pi minus the sum.
  Real defect() const {
    const Mask near = is_short(product_);
    Real angle = short_argument(product_);
    if (any(~near)) angle = select(near, angle, argument(product_));
    // The argument runs from -pi to pi; a sum just below a full turn has a small negative one.
    const Real turns = __builtin_convertvector(turns_, Real);
    const Real whole = select(angle < 0.0, -turns, 1.0 - turns);
    return 2.0 * k_pi * whole - angle;
  }

 private:
  Real size() const { return max(absolute(product_.re), absolute(product_.im)); }

  void shrink() {
    smallest_ = min(smallest_, size());
    const Real factor = exponent_off(size());
    product_ = {factor * product_.re, factor * product_.im};
  }

  Complex product_{broadcast(1.0), Real{}};
  Real smallest_ = broadcast(1.0);
  Bits turns_{}, was_lower_{};
  int factors_ = 0;
};

}  // namespace planish::PLANISH_ISA
