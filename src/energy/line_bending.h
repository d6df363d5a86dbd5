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
};

/// Keeps moves smooth along lines: the mean of |second difference|^2 / length^2.
class LineBending {
 public:
  LineBending(std::vector<SecondDifference> differences, double length);

  std::span<const SecondDifference> differences() const { return differences_; }
  /// Of each square.
  double weight() const { return weight_; }
  double value(const std::vector<Vec3>& moves) const;

 private:
  std::vector<SecondDifference> differences_;
  double weight_ = 0.0;
};

}  // namespace planish
