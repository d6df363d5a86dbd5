#include "energy/symmetric_dirichlet.h"

#include <cmath>

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include "support/meshes.h"

namespace planish {
namespace {

using Corners = std::array<double, 6>;

const RestTriangle k_rest{1.3, {0.4, 0.9}};

TriangleEnergy energy_at(const Corners& p) {
  return {k_rest, {p[0], p[1]}, {p[2], p[3]}, {p[4], p[5]}};
}

/// A triangle laid flat somewhere, stretched by up to a factor of about four, not flipped.
Corners random_corners(meshes::Random& random) {
  for (;;) {
    Corners p{};
    for (double& x : p)
      x = 2.0 * random.number();
    const double area = (p[2] - p[0]) * (p[5] - p[1]) - (p[4] - p[0]) * (p[3] - p[1]);
    if (area > 0.3) return p;
  }
}

TEST(SymmetricDirichlet, IsZeroWhereNothingIsStretched) {
  const double c = std::cos(0.7), s = std::sin(0.7);
  const auto turned = [&](Vec2 p) {
    return Vec2{c * p.x - s * p.y + 3.0, s * p.x + c * p.y - 1.0};
  };
  const TriangleEnergy energy(k_rest, turned({0, 0}), turned({k_rest.length, 0}),
                              turned(k_rest.tip));
  EXPECT_LT(energy.value(), 1e-30);
  for (const double g : energy.gradient())
    EXPECT_NEAR(g, 0.0, 1e-14);
}

TEST(SymmetricDirichlet, WeighsStretchingAndShrinkingAlike) {
  const auto scaled = [](double s) {
    return TriangleEnergy(k_rest, {0, 0}, {s * k_rest.length, 0}, s * k_rest.tip).value();
  };
  EXPECT_NEAR(scaled(2.0), scaled(0.5), 1e-12);
  EXPECT_NEAR(scaled(2.0), 2.0 * 2.25 * k_rest.area(), 1e-12);
}

TEST(SymmetricDirichlet, GradientIsTheDifferenceQuotient) {
  meshes::Random random(1);
  constexpr double h = 1e-6;
  for (int trial = 0; trial < 300; ++trial) {
    const Corners p = random_corners(random);
    const auto gradient = energy_at(p).gradient();
    for (int i = 0; i < 6; ++i) {
      Corners more = p, less = p;
      more[i] += h, less[i] -= h;
      const double difference = (energy_at(more).value() - energy_at(less).value()) / (2.0 * h);
      ASSERT_NEAR(gradient[i], difference, 1e-6 * (1.0 + std::abs(difference))) << trial;
    }
  }
}

Eigen::Matrix<double, 6, 6> difference_hessian(const Corners& p) {
  constexpr double h = 1e-6;
  Eigen::Matrix<double, 6, 6> hessian;
  for (int i = 0; i < 6; ++i) {
    Corners more = p, less = p;
    more[i] += h, less[i] -= h;
    const auto up = energy_at(more).gradient(), down = energy_at(less).gradient();
    for (int j = 0; j < 6; ++j)
      hessian(i, j) = (up[j] - down[j]) / (2.0 * h);
  }
  return hessian;
}

Eigen::Matrix<double, 6, 6> hessian_at(const Corners& p, Curvature curvature) {
  const auto rows = energy_at(p).hessian(curvature);
  Eigen::Matrix<double, 6, 6> hessian;
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j < 6; ++j)
      hessian(i, j) = rows[i][j];
  }
  return hessian;
}

TEST(SymmetricDirichlet, HessianIsTheDifferenceQuotient) {
  meshes::Random random(3);
  for (int trial = 0; trial < 300; ++trial) {
    const Corners p = random_corners(random);
    const Eigen::Matrix<double, 6, 6> expected = difference_hessian(p);
    ASSERT_LT((hessian_at(p, Curvature::full) - expected).norm(), 1e-5 * expected.norm()) << trial;
  }
}

TEST(SymmetricDirichlet, ProjectedHessianIsTheDifferenceQuotientWithoutItsNegativePart) {
  meshes::Random random(2);
  int projected = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const Corners p = random_corners(random);
    const Eigen::Matrix<double, 6, 6> ours = hessian_at(p, Curvature::projected);
    const Eigen::Matrix<double, 6, 6> expected = difference_hessian(p);
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>> eigen(ours);
    const double size = expected.norm();
    ASSERT_GT(eigen.eigenvalues().minCoeff(), -1e-10 * size);
    // What is missing has no positive part: ours - expected is positive semidefinite.
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>> gap(ours - expected);
    ASSERT_GT(gap.eigenvalues().minCoeff(), -1e-5 * size);
    const bool indefinite = Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>>(expected)
                                .eigenvalues()
                                .minCoeff() < -1e-3 * size;
    if (indefinite) {
      ++projected;
    } else {
      ASSERT_LT((ours - expected).norm(), 1e-2 * size) << trial;
    }
  }
  EXPECT_GT(projected, 20);
}

}  // namespace
}  // namespace planish
