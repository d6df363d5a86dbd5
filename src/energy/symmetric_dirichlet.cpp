#include "energy/symmetric_dirichlet.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/math.h"
#include "core/neumaier_sum.h"

namespace planish {

namespace {

// f(s) = s^2 + 1 / s^2, of which the energy is the sum over both stretches.
double f_slope(double s) {
  return 2.0 * s - 2.0 / (s * s * s);
}
double f_curvature(double s) {
  return 2.0 + 6.0 / (s * s * s * s);
}
double square(double x) {
  return x * x;
}

/// A unit vector at half the angle of this one, or opposite to it.
Vec2 half_angle(Vec2 unit) {
  const Vec2 along = unit.x >= 0.0 ? Vec2{1.0 + unit.x, unit.y} : Vec2{unit.y, 1.0 - unit.x};
  return (1.0 / norm(along)) * along;
}

}  // namespace

TriangleEnergy::TriangleEnergy(const RestTriangle& rest, Vec2 p0, Vec2 p1, Vec2 p2)
    : area_(rest.area()) {
  // F = [p1 - p0, p2 - p0] * inverse of [(length, 0), tip]
  const double l = rest.length, tx = rest.tip.x, ty = rest.tip.y;
  shape_[1] = {1.0 / l, -tx / (l * ty)};
  shape_[2] = {0.0, 1.0 / ty};
  shape_[0] = Vec2{} - shape_[1] - shape_[2];
  const Vec2 d1 = p1 - p0, d2 = p2 - p0;
  const Matrix2 F{d1.x * shape_[1].x + d2.x * shape_[2].x, d1.x * shape_[1].y + d2.x * shape_[2].y,
                  d1.y * shape_[1].x + d2.y * shape_[2].x, d1.y * shape_[1].y + d2.y * shape_[2].y};
  // Singular values and vectors in closed form: F is a rotation part plus a reflection part.
  const double turn_re = 0.5 * (F.xx + F.yy), turn_im = 0.5 * (F.yx - F.xy);
  const double flip_re = 0.5 * (F.xx - F.yy), flip_im = 0.5 * (F.yx + F.xy);
  const double turn = math::hypot(turn_re, turn_im), flip = math::hypot(flip_re, flip_im);
  s1_ = turn + flip;
  // turn - flip, without the loss of digits that the difference has in a thin triangle
  s2_ = cross(d1, d2) / (l * ty) / s1_;
  // v1 is at half the angle from the rotation to the reflection, and u1 is v1 rotated. With -v1 for
  // v1 both change sign, which no product of the two sees.
  const Vec2 rotation = (1.0 / turn) * Vec2{turn_re, turn_im};
  v1_ = flip > 0.0 ? half_angle((1.0 / flip) * Vec2{dot(rotation, {flip_re, flip_im}),
                                                    cross(rotation, {flip_re, flip_im})})
                   : Vec2{1.0, 0.0};
  u1_ = {rotation.x * v1_.x - rotation.y * v1_.y, rotation.x * v1_.y + rotation.y * v1_.x};
  u2_ = {-u1_.y, u1_.x};
  v2_ = {-v1_.y, v1_.x};
  value_ = area_ * (square(s1_ - 1.0 / s1_) + square(s2_ - 1.0 / s2_));
}

std::array<double, 6> TriangleEnergy::corner_terms(const Matrix2& m) const {
  std::array<double, 6> terms{};
  for (int k = 0; k < 3; ++k) {
    terms[2 * k] = m.xx * shape_[k].x + m.xy * shape_[k].y;
    terms[2 * k + 1] = m.yx * shape_[k].x + m.yy * shape_[k].y;
  }
  return terms;
}

std::array<double, 6> TriangleEnergy::gradient() const {
  const double g1 = area_ * f_slope(s1_), g2 = area_ * f_slope(s2_);
  return corner_terms(
      {g1 * u1_.x * v1_.x + g2 * u2_.x * v2_.x, g1 * u1_.x * v1_.y + g2 * u2_.x * v2_.y,
       g1 * u1_.y * v1_.x + g2 * u2_.y * v2_.x, g1 * u1_.y * v1_.y + g2 * u2_.y * v2_.y});
}

std::array<std::array<double, 6>, 6> TriangleEnergy::hessian(Curvature curvature) const {
  const auto outer = [](Vec2 u, Vec2 v) {
    return Matrix2{u.x * v.x, u.x * v.y, u.y * v.x, u.y * v.y};
  };
  const auto combine = [&](double sign) {  // (u2 v1' + sign u1 v2') / sqrt(2)
    const Matrix2 a = outer(u2_, v1_), b = outer(u1_, v2_);
    const double h = std::sqrt(0.5);
    return Matrix2{h * (a.xx + sign * b.xx), h * (a.xy + sign * b.xy), h * (a.yx + sign * b.yx),
                   h * (a.yy + sign * b.yy)};
  };
  const double full_twist = (f_slope(s1_) + f_slope(s2_)) / (s1_ + s2_);
  const double twist = curvature == Curvature::full ? full_twist : std::max(full_twist, 0.0);
  // (f'(s1) - f'(s2)) / (s1 - s2), also where they are equal
  const double product = s1_ * s2_;
  const double shear =
      2.0 + 2.0 * (s1_ * s1_ + product + s2_ * s2_) / (product * product * product);
  struct Mode {
    double eigenvalue;
    std::array<double, 6> terms;
  };
  const std::array<Mode, 4> modes{{{f_curvature(s1_), corner_terms(outer(u1_, v1_))},
                                   {f_curvature(s2_), corner_terms(outer(u2_, v2_))},
                                   {twist, corner_terms(combine(-1.0))},
                                   {shear, corner_terms(combine(1.0))}}};
  std::array<std::array<double, 6>, 6> hessian{};
  for (const Mode& mode : modes) {
    for (int i = 0; i < 6; ++i) {
      const double scaled = area_ * mode.eigenvalue * mode.terms[i];
      for (int j = 0; j < 6; ++j)
        hessian[i][j] += scaled * mode.terms[j];
    }
  }
  return hessian;
}

double symmetric_dirichlet(std::span<const Triangle> triangles, std::span<const RestTriangle> rest,
                           std::span<const Vec2> flat) {
  NeumaierSum sum;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const auto [a, b, c] = triangles[t];
    if (!(cross(flat[b] - flat[a], flat[c] - flat[a]) > 0.0))
      return std::numeric_limits<double>::infinity();
    sum.add(TriangleEnergy(rest[t], flat[a], flat[b], flat[c]).value());
  }
  return sum.value();
}

}  // namespace planish
