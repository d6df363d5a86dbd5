#include "pattern/curves/fit_cubic.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "pattern/curves/piece_math.h"

namespace planish {

namespace {

constexpr int k_most_steps = 12;
constexpr double k_hopeless = 30.0;  // tolerances: few steps will not mend it

/// Solves for the first n unknowns; false where the matrix is singular.
bool solve(std::array<std::array<double, 4>, 4>& matrix, std::array<double, 4>& right,
           std::size_t n) {
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    for (std::size_t row = k + 1; row < n; ++row) {
      if (std::abs(matrix[row][k]) > std::abs(matrix[pivot][k])) pivot = row;
    }
    if (!(std::abs(matrix[pivot][k]) > 1e-12)) return false;
    std::swap(matrix[k], matrix[pivot]);
    std::swap(right[k], right[pivot]);
    for (std::size_t row = k + 1; row < n; ++row) {
      const double factor = matrix[row][k] / matrix[k][k];
      for (std::size_t column = k; column < n; ++column)
        matrix[row][column] -= factor * matrix[k][column];
      right[row] -= factor * right[k];
    }
  }
  for (std::size_t k = n; k-- > 0;) {
    for (std::size_t column = k + 1; column < n; ++column)
      right[k] -= matrix[k][column] * right[column];
    right[k] /= matrix[k][k];
  }
  return true;
}

/// The directions in which a control point may leave its end: the given one, or both axes.
std::vector<Vec2> choices(const std::optional<Vec2>& direction) {
  if (direction) return {*direction};
  return {{1.0, 0.0}, {0.0, 1.0}};
}

class CubicFit {
 public:
  CubicFit(std::span<const Vec2> points, const EndDirections& ends)
      : points_(points),
        first_(choices(ends.first)),
        last_(choices(ends.last ? std::optional(-1.0 * *ends.last) : std::nullopt)) {
    parameters_.reserve(points.size());
    parameters_.push_back(0.0);
    for (std::size_t i = 1; i < points.size(); ++i)
      parameters_.push_back(parameters_.back() + norm(points[i] - points[i - 1]));
    chord_ = parameters_.back();
    for (double& t : parameters_)
      t /= chord_;
    parameters_.back() = 1.0;
  }

  /// The best cubic for the parameters as they are.
  CubicTo best() const {
    const std::size_t n = first_.size() + last_.size();
    std::array<std::array<double, 4>, 4> matrix = {};
    std::array<double, 4> right = {};
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const double t = parameters_[i], s = 1.0 - t;
      const double begin = s * s * (s + 3.0 * t), end = t * t * (t + 3.0 * s);
      const Vec2 rest = points_[i] - begin * points_.front() - end * points_.back();
      std::array<Vec2, 4> parts;
      for (std::size_t k = 0; k < n; ++k)
        parts[k] = k < first_.size() ? 3.0 * s * s * t * first_[k]
                                     : 3.0 * s * t * t * last_[k - first_.size()];
      for (std::size_t k = 0; k < n; ++k) {
        for (std::size_t l = 0; l < n; ++l)
          matrix[k][l] += dot(parts[k], parts[l]);
        right[k] += dot(parts[k], rest);
      }
    }
    const bool solved = solve(matrix, right, n);
    const auto sum = [&](const std::vector<Vec2>& directions, std::size_t from) {
      // A given direction must not turn round.
      if (!solved || (directions.size() == 1 && !(right[from] > 1e-3 * chord_)))
        return chord_ / 3.0 * (directions.size() == 1 ? directions[0] : Vec2{});
      Vec2 offset;
      for (std::size_t k = 0; k < directions.size(); ++k)
        offset = offset + right[from + k] * directions[k];
      return offset;
    };
    return {points_.front() + sum(first_, 0), points_.back() + sum(last_, first_.size()),
            points_.back()};
  }

  /// One step of Newton's method for the foot of every point.
  void improve_parameters(const CubicTo& cubic) {
    for (std::size_t i = 1; i + 1 < points_.size(); ++i) {
      const PlaceOnPiece place = place_on(points_.front(), cubic, parameters_[i]);
      const Vec2 apart = place.at - points_[i];
      const double slope = dot(place.speed, place.speed) + dot(apart, place.bend);
      if (!(slope > 0.0)) continue;
      const double t = parameters_[i] - dot(apart, place.speed) / slope;
      parameters_[i] = std::clamp(t, parameters_[i - 1], 1.0);
    }
  }

  /// At the points, and between them half way between their parameters.
  FittedCubic measured(const CubicTo& cubic) const {
    FittedCubic fitted{cubic};
    const auto count = [&](double distance, std::size_t i) {
      if (!(distance > fitted.distance)) return;
      fitted.distance = distance;
      fitted.worst = i;
    };
    for (std::size_t i = 1; i < points_.size(); ++i) {
      const Vec2 way = points_[i] - points_[i - 1];
      const double t = 0.5 * (parameters_[i - 1] + parameters_[i]);
      const Vec2 apart = place_on(points_.front(), cubic, t).at - points_[i - 1];
      const double share = std::clamp(dot(apart, way) / dot(way, way), 0.0, 1.0);
      count(norm(apart - share * way), i);
      if (i + 1 < points_.size())
        count(norm(place_on(points_.front(), cubic, parameters_[i]).at - points_[i]), i);
    }
    return fitted;
  }

 private:
  std::span<const Vec2> points_;
  std::vector<Vec2> first_, last_;
  std::vector<double> parameters_;  // of every point
  double chord_ = 0.0;              // the length of the line
};

}  // namespace

FittedCubic fit_cubic(std::span<const Vec2> points, const EndDirections& ends, double tolerance) {
  CubicFit fit(points, ends);
  FittedCubic best = fit.measured(fit.best());
  for (int step = 0; step < k_most_steps && best.distance > tolerance; ++step) {
    if (step >= 2 && best.distance > k_hopeless * tolerance) break;
    fit.improve_parameters(best.cubic);
    const FittedCubic next = fit.measured(fit.best());
    const bool is_better = next.distance < best.distance;
    if (is_better) best = next;
    if (!is_better && step >= 4) break;
  }
  return best;
}

}  // namespace planish
