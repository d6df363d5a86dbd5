#pragma once

#include <array>
#include <span>

#include <planish/mesh/tri_mesh.h>

namespace planish {

/// A triangle of the patch laid into the plane by itself: corners at (0, 0), (length, 0) and tip,
/// tip.y > 0. A triangle without area gets a little.
struct RestTriangle {
  double length = 1.0;
  Vec2 tip;

  double area() const { return 0.5 * length * tip.y; }
};

/// Whether second derivatives are taken as they are.
enum class Curvature { full, projected };

/// The symmetric Dirichlet energy of one triangle laid flat, less its value where nothing is
/// stretched (docs/unfold.md, "What is minimised"),
///
///     E = A ((s1 - 1 / s1)^2 + (s2 - 1 / s2)^2),
///
/// A its area, s1 and s2 the principal stretches. It is 0 without stretch, grows alike for
/// stretching and shrinking, and without bound as a triangle collapses, so that a path of finite
/// energy cannot flip one.
class TriangleEnergy {
 public:
  /// @pre the triangle is not flipped in the plane
  TriangleEnergy(const RestTriangle& rest, Vec2 p0, Vec2 p1, Vec2 p2);

  double value() const { return value_; }
  /// With respect to x and y of the three corners, in turn.
  std::array<double, 6> gradient() const;
  /// The second derivative from its eigenvectors in closed form (Smith, de Goes, Kim 2019). One
  /// eigenvalue may be negative; `projected` raises it to 0.
  std::array<std::array<double, 6>, 6> hessian(Curvature curvature) const;

 private:
  struct Matrix2 {
    double xx, xy, yx, yy;
  };
  std::array<double, 6> corner_terms(const Matrix2& m) const;

  double area_ = 0.0, value_ = 0.0;
  std::array<Vec2, 3> shape_;   // the gradients of the linear shape functions
  double s1_ = 1.0, s2_ = 1.0;  // stretches
  Vec2 u1_, u2_, v1_, v2_;      // their directions in the plane and on the patch
};

/// E of all triangles; infinite where one has no positive area.
double symmetric_dirichlet(std::span<const Triangle> triangles, std::span<const RestTriangle> rest,
                           std::span<const Vec2> flat);

}  // namespace planish
