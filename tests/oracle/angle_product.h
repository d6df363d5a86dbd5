#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include <planish/core/vec.h>

namespace planish {

/// A corner as a complex number whose argument is its angle, 0 to pi: (a . b, |a x b|). Its size is
/// of no account.
struct Corner {
  double re = 1.0, im = 0.0;
};

inline Corner corner_between(Vec3 a, Vec3 b) {
  return {dot(a, b), norm(cross(a, b))};
}

/// A sum of angles, kept as a product of corners and a count of full turns: angles add where
/// complex numbers multiply. One arctangent gives the sum, and no digits are lost near 2 pi.
class AngleProduct {
 public:
  /// Adds an angle of 0 to pi.
  void add(Corner c) {
    if (c.re == 0.0 && c.im == 0.0) return;  // at an edge of length zero there is no angle
    const double re = re_ * c.re - im_ * c.im;
    const double im = re_ * c.im + im_ * c.re;
    const bool was_lower = lower_half();
    // Kept near 1, so that the product over a star of any valence neither overflows nor vanishes.
    const double size = std::max(std::abs(re), std::abs(im));
    const double shrink = size > 0.0 ? 1.0 / size : 1.0;
    re_ = size > 0.0 ? shrink * re : 1.0;
    im_ = size > 0.0 ? shrink * im : 0.0;
    // No angle is above pi, so only a step from the lower to the upper half ends a turn.
    if (was_lower && !lower_half()) ++turns_;
  }

  /// 2 pi minus the sum.
  double defect() const {
    const double arg = std::atan2(im_, re_);
    return 2.0 * std::numbers::pi * (arg < 0.0 ? -turns_ : 1.0 - turns_) - arg;
  }

 private:
  // Argument from pi (included) to 2 pi.
  bool lower_half() const { return im_ < 0.0 || (im_ == 0.0 && re_ < 0.0); }

  double re_ = 1.0, im_ = 0.0;
  double turns_ = 0.0;
};

}  // namespace planish
