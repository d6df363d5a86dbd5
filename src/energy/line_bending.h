#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include <planish/core/vec.h>

namespace planish {

/// Three vertices of a line that follow one another, and what a function is at the second beyond
/// the straight line through the other two: w . (f_a, f_b, f_c), twice, as second differences are.
struct SecondDifference {
  std::array<Index, 3> vertices;
  std::array<double, 3> weights;

  /// Of values by vertex; those of vertices behind the last one are zero.
  Vec3 of(const std::vector<Vec3>& values) const {
    Vec3 sum;
    for (std::size_t k = 0; k < 3; ++k) {
      if (vertices[k] < values.size()) sum += weights[k] * values[vertices[k]];
    }
    return sum;
  }
  /// Of its part along an axis, by each vertex.
  std::array<Vec3, 3> gradient(Vec3 axis) const {
    return {weights[0] * axis, weights[1] * axis, weights[2] * axis};
  }
};

/// Keeps moves smooth along lines,
///
///     sum of |f|^2 / (n l^2),
///
/// f the n second differences of the moves, l a length (docs/methods/smooth.md).
class LineBending {
 public:
  LineBending(std::vector<SecondDifference> differences, double length);

  std::span<const SecondDifference> differences() const { return differences_; }
  /// k of each: the Hessian is k times the sum over axes of the squares of gradient(axis).
  double stiffness() const { return 2.0 * weight_; }
  /// Of one of them, by each of its vertices.
  std::array<Vec3, 3> gradient(const SecondDifference& difference,
                               const std::vector<Vec3>& moves) const {
    const auto& w = difference.weights;
    const Vec3 f = difference.of(moves);
    return {stiffness() * w[0] * f, stiffness() * w[1] * f, stiffness() * w[2] * f};
  }
  double value(const std::vector<Vec3>& moves) const;

 private:
  std::vector<SecondDifference> differences_;
  double weight_ = 0.0;
};

}  // namespace planish
