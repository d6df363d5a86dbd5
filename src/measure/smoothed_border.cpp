#include "measure/smoothed_border.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>

#include "core/neumaier_sum.h"
#include "geometry/angle_between.h"

namespace planish {

namespace {

using Points = std::vector<Vec3>;

/// A closed curve through points, some of which are held.
class SmoothedLoop {
 public:
  SmoothedLoop(Points points, double wave) : points_(std::move(points)), held_(points_.size()) {
    const std::size_t n = points_.size();
    NeumaierSum length;
    for (std::size_t i = 0; i < n; ++i) {
      steps_.push_back(norm(points_[next(i)] - points_[i]));
      length.add(steps_.back());
    }
    const double mean = length.value() / static_cast<double>(n);
    const double root = 0.5 * wave / (std::numbers::pi * mean);
    stiffness_ = root * root * root * root;
    hold_corners(0.25 * wave);
  }

  /// By conjugate gradients.
  Points smooth() const {
    constexpr int most_steps = 1000;
    constexpr double enough = 1e-20;  // of the squares
    Points moves(points_.size()), residual = matrix_times(points_, 0.0);
    for (Vec3& r : residual)
      r = -1.0 * r;
    Points direction = residual;
    double now = square(residual);
    const double first = now;
    for (int k = 0; k < most_steps && now > enough * first; ++k) {
      const Points change = matrix_times(direction, 1.0);
      const double step = now / product(direction, change);
      add(moves, step, direction);
      add(residual, -step, change);
      const double before = now;
      now = square(residual);
      for (std::size_t i = 0; i < direction.size(); ++i)
        direction[i] = residual[i] + (now / before) * direction[i];
    }
    add(moves, 1.0, points_);
    return moves;
  }

 private:
  std::size_t next(std::size_t i) const { return i + 1 < points_.size() ? i + 1 : 0; }
  std::size_t previous(std::size_t i) const { return i > 0 ? i - 1 : points_.size() - 1; }

  static void add(Points& to, double factor, const Points& what) {
    for (std::size_t i = 0; i < to.size(); ++i)
      to[i] = to[i] + factor * what[i];
  }
  static double product(const Points& a, const Points& b) {
    NeumaierSum sum;
    for (std::size_t i = 0; i < a.size(); ++i)
      sum.add(dot(a[i], b[i]));
    return sum.value();
  }
  static double square(const Points& a) { return product(a, a); }

  double turn_at(std::size_t i, double arm) const {
    const auto place = [&](auto step) {
      std::size_t k = i;
      for (std::size_t n = 0; n < points_.size() && norm(points_[k] - points_[i]) < arm; ++n)
        k = step(k);
      return points_[k];
    };
    const Vec3 behind = place([&](std::size_t k) { return previous(k); });
    const Vec3 ahead = place([&](std::size_t k) { return next(k); });
    return angle_between(points_[i] - behind, ahead - points_[i]);
  }

  /// Of neighbours that turn by much the one that turns most.
  void hold_corners(double arm) {
    constexpr double sharp = std::numbers::pi / 4.0;
    std::vector<double> turns;
    for (std::size_t i = 0; i < points_.size(); ++i)
      turns.push_back(turn_at(i, arm));
    const auto is_less_than_near = [&](std::size_t i, auto step) {
      std::size_t k = step(i);
      for (; k != i && norm(points_[k] - points_[i]) < arm; k = step(k)) {
        if (turns[k] > turns[i]) return true;
      }
      return false;
    };
    for (std::size_t i = 0; i < points_.size(); ++i)
      held_[i] = turns[i] > sharp &&
                 !is_less_than_near(i, [&](std::size_t k) { return next(k); }) &&
                 !is_less_than_near(i, [&](std::size_t k) { return previous(k); });
  }

  /// Twice the way from the chord between its neighbours, the second difference where steps are
  /// even; 0 at a corner.
  Vec3 bend_at(std::size_t i, const Points& x) const {
    const double behind = steps_[previous(i)], ahead = steps_[i], both = behind + ahead;
    if (held_[i] || !(both > 0.0)) return {};
    const Vec3 chord = (ahead / both) * x[previous(i)] + (behind / both) * x[next(i)];
    return 2.0 * (x[i] - chord);
  }

  /// (identity + t B^T B) x, B the bends; 0 where a point is held.
  Points matrix_times(const Points& x, double identity) const {
    Points result(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) {
      result[i] = result[i] + identity * x[i];
      const double behind = steps_[previous(i)], ahead = steps_[i], both = behind + ahead;
      if (held_[i] || !(both > 0.0)) continue;
      const Vec3 bend = (2.0 * stiffness_) * bend_at(i, x);
      result[i] = result[i] + bend;
      result[previous(i)] = result[previous(i)] - (ahead / both) * bend;
      result[next(i)] = result[next(i)] - (behind / both) * bend;
    }
    for (std::size_t i = 0; i < x.size(); ++i) {
      if (held_[i]) result[i] = {};
    }
    return result;
  }

  Points points_;
  std::vector<bool> held_;
  std::vector<double> steps_;  // from a point to the next
  double stiffness_ = 0.0;
};

}  // namespace

std::vector<Vec3> with_smoothed_border(const Patch& patch, double wave) {
  constexpr std::size_t least = 4;
  const double scale = patch.unit_scale();
  std::vector<Vec3> positions = patch.positions();
  for (const std::vector<Index>& loop : patch.border_loops()) {
    if (loop.size() < least) continue;
    Points points;
    for (const Index v : loop)
      points.push_back(scale * positions[v]);
    const Points smooth = SmoothedLoop(points, scale * wave).smooth();
    for (std::size_t i = 0; i < loop.size(); ++i)
      positions[loop[i]] += (1.0 / scale) * (smooth[i] - points[i]);
  }
  return positions;
}

}  // namespace planish
