#include "geometry/angle_gradient.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>

#include <gtest/gtest.h>

#include "oracle/plain.h"
#include "support/meshes.h"

namespace planish {
namespace {

using Corners = std::array<Vec3, 3>;  // p, q, r
using Complex = std::complex<double>;
using ComplexVec = std::array<Complex, 3>;

double& coordinate(Vec3& p, int axis) {
  return axis == 0 ? p.x : axis == 1 ? p.y : p.z;
}

std::array<Vec3, 3> gradient_of(const Corners& t) {
  const AngleGradient g = angle_gradient(t[0], t[1], t[2]);
  return {g.at_p, g.at_q, g.at_r};
}

Corners random_corners(meshes::Random& random) {
  Corners t;
  for (Vec3& p : t)
    p = {random.number(), random.number(), random.number()};
  return t;
}

/// The angle at p in complex numbers: by whichever arctangent is far from its pole.
Complex complex_angle(const std::array<ComplexVec, 3>& t) {
  ComplexVec a, b;
  for (int k = 0; k < 3; ++k) {
    a[k] = t[1][k] - t[0][k];
    b[k] = t[2][k] - t[0][k];
  }
  Complex squares = 0.0, product = 0.0;
  for (int k = 0; k < 3; ++k) {
    const int l = (k + 1) % 3, m = (k + 2) % 3;
    const Complex c = a[l] * b[m] - a[m] * b[l];
    squares += c * c;
    product += a[k] * b[k];
  }
  const Complex area = std::sqrt(squares);
  constexpr double pi = std::numbers::pi;
  if (std::abs(product.real()) < area.real()) return pi / 2.0 - std::atan(product / area);
  return std::atan(area / product) + (product.real() < 0.0 ? pi : 0.0);
}

/// The derivative by a step of 1e-30 along the imaginary axis, which loses no digits.
double complex_step(const Corners& t, int corner, int axis) {
  constexpr double h = 1e-30;
  std::array<ComplexVec, 3> moved;
  for (int k = 0; k < 3; ++k)
    moved[k] = {t[k].x, t[k].y, t[k].z};
  moved[corner][axis] += Complex(0.0, h);
  return complex_angle(moved).imag() / h;
}

void expect_complex_steps(const Corners& t, double relative) {
  const auto gradient = gradient_of(t);
  for (int corner = 0; corner < 3; ++corner) {
    const double size = norm(gradient[corner]);
    for (int axis = 0; axis < 3; ++axis) {
      Vec3 g = gradient[corner];
      EXPECT_NEAR(coordinate(g, axis), complex_step(t, corner, axis), relative * size)
          << "corner " << corner << " axis " << axis;
    }
  }
}

TEST(AngleGradient, IsTheDifferenceQuotient) {
  meshes::Random random(1);
  constexpr double h = 1e-6;
  for (int round = 0; round < 500; ++round) {
    const Corners t = random_corners(random);
    const auto gradient = gradient_of(t);
    // The third derivative grows with the inverse third power of the edges and the sine.
    const Vec3 a = t[1] - t[0], b = t[2] - t[0];
    const double length = std::min(norm(a), norm(b));
    const double sine = norm(cross(a, b)) / (norm(a) * norm(b));
    if (length * sine < 0.05) continue;
    for (int corner = 0; corner < 3; ++corner) {
      for (int axis = 0; axis < 3; ++axis) {
        Corners less = t, more = t;
        coordinate(less[corner], axis) -= h;
        coordinate(more[corner], axis) += h;
        const auto angle = [](const Corners& c) {
          return plain::angle_between(c[1] - c[0], c[2] - c[0]);
        };
        Vec3 g = gradient[corner];
        EXPECT_NEAR(coordinate(g, axis), (angle(more) - angle(less)) / (2.0 * h), 1e-7);
      }
    }
  }
}

TEST(AngleGradient, IsTheComplexStepOnRandomTriangles) {
  meshes::Random random(2);
  for (int round = 0; round < 2000; ++round)
    expect_complex_steps(random_corners(random), 1e-11);
}

TEST(AngleGradient, IsTheComplexStepOnNeedles) {
  // Sharp and nearly straight corners at p, and needles whose short edge is at p.
  meshes::Random random(3);
  for (const double height : {1e-3, 1e-6, 1e-9}) {
    for (const double x : {1.7, -0.6, height}) {
      // No coordinate is 0, so that the complex root has a slope along every axis.
      expect_complex_steps({Vec3{}, {1.0, 0.0, 0.0}, {x, height, 0.5 * height}}, 1e-13);
      expect_complex_steps({Vec3{}, {x, 0.5 * height, height}, {1.0, 0.0, 0.0}}, 1e-13);
    }
  }
}

TEST(AngleGradient, IsAsLongAsOneOverTheEdge) {
  meshes::Random random(4);
  for (int round = 0; round < 500; ++round) {
    const Corners t = random_corners(random);
    const AngleGradient g = angle_gradient(t[0], t[1], t[2]);
    EXPECT_NEAR(norm(g.at_q) * norm(t[1] - t[0]), 1.0, 1e-14);
    EXPECT_NEAR(norm(g.at_r) * norm(t[2] - t[0]), 1.0, 1e-14);
  }
}

TEST(AngleGradient, OfTheThreeCornersSumsToNothing) {
  // As the angles of a triangle sum to pi wherever its corners are.
  meshes::Random random(5);
  for (int round = 0; round < 500; ++round) {
    const Corners t = random_corners(random);
    const AngleGradient p = angle_gradient(t[0], t[1], t[2]);
    const AngleGradient q = angle_gradient(t[1], t[2], t[0]);
    const AngleGradient r = angle_gradient(t[2], t[0], t[1]);
    const double size = norm(p.at_p) + norm(q.at_p) + norm(r.at_p);
    EXPECT_LT(norm(p.at_p + q.at_r + r.at_q), 1e-12 * size);
    EXPECT_LT(norm(p.at_q + q.at_p + r.at_r), 1e-12 * size);
  }
}

TEST(AngleGradient, DoesNotDependOnTheOrientation) {
  meshes::Random random(6);
  for (int round = 0; round < 100; ++round) {
    const Corners t = random_corners(random);
    const AngleGradient g = angle_gradient(t[0], t[1], t[2]);
    const AngleGradient turned = angle_gradient(t[0], t[2], t[1]);
    EXPECT_LT(norm(g.at_p - turned.at_p), 1e-14 * norm(g.at_p));
    EXPECT_EQ(g.at_q, turned.at_r);
    EXPECT_EQ(g.at_r, turned.at_q);
  }
}

TEST(AngleGradient, IsNothingWhereTheAngleHasNone) {
  for (const Corners& t : {Corners{Vec3{}, {1, 0, 0}, {2, 0, 0}},
                           Corners{Vec3{}, {1, 0, 0}, {-1, 0, 0}}, Corners{Vec3{}, {}, {1, 0, 0}}})
    for (const Vec3 g : gradient_of(t))
      EXPECT_EQ(g, Vec3{});
}

}  // namespace
}  // namespace planish
