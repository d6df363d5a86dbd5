#include "unfold/stretch/least_stretch.h"

#include <algorithm>
#include <cmath>

#include "optimize/line_search.h"
#include "unfold/stretch/flat_steps.h"

namespace planish {

namespace {

/// Finds one Newton step after another with a factor of one of their matrices.
class LaggedSolver {
 public:
  explicit LaggedSolver(StretchSystem& system) : system_(system) {}

  /// The step from there, of which the system is left as solved; an empty vector where the matrix
  /// cannot be factored.
  Eigen::VectorXd step(const std::vector<Vec2>& flat) {
    if (factored_) {
      system_.assemble(flat, Curvature::full);
      auto step = conjugate_gradients();
      if (step.size() > 0) return step;
    }
    system_.assemble(flat, Curvature::projected);
    factored_ = system_.factor();
    if (!factored_) return {};
    return system_.solve(system_.right());
  }

 private:
  /// Preconditioned with the factor at hand; empty if that takes too many steps.
  Eigen::VectorXd conjugate_gradients() const {
    constexpr int most_steps = 12;
    constexpr double enough = 1e-2;  // of the residual: Newton's own error is of that kind
    const auto matrix = system_.hessian().selfadjointView<Eigen::Lower>();
    Eigen::VectorXd residual = system_.right();
    Eigen::VectorXd x = Eigen::VectorXd::Zero(residual.size());
    Eigen::VectorXd z = system_.solve(residual), direction = z;
    double rz = residual.dot(z);
    const double first = rz;
    for (int step = 0; step < most_steps; ++step) {
      const Eigen::VectorXd image = matrix * direction;
      const double length = rz / direction.dot(image);
      if (!std::isfinite(length) || length <= 0.0) return {};
      x += length * direction;
      residual -= length * image;
      z = system_.solve(residual);
      const double next = residual.dot(z);
      if (next <= enough * enough * first) return x;
      direction = z + (next / rz) * direction;
      rz = next;
    }
    return {};
  }

  StretchSystem& system_;
  bool factored_ = false;
};

}  // namespace

LeastStretch minimise_stretch(const Disk& disk, StretchSystem& system, std::vector<Vec2> start,
                              int max_iterations, const std::function<void()>& after_step) {
  // A stretch of 1e-9 everywhere is none; and what a further step would gain must be worth it.
  constexpr double no_energy = 4e-18, least_gain = 1e-6, least_fall = 1e-4;
  LeastStretch result{turn_to_axis(disk, std::move(start)), 0, false};
  LaggedSolver solver(system);
  double energy = total_energy(disk, result.flat);
  for (; result.iterations < max_iterations; ++result.iterations) {
    if ((result.converged = energy <= no_energy)) break;
    const Eigen::VectorXd step = solver.step(result.flat);
    if (step.size() == 0) break;
    const double slope = system.gradient().dot(step);
    if (!(slope < 0.0) || -slope <= least_gain * energy) {
      // Only a step that does solve the system tells that there is nothing left to gain.
      result.converged = system.solved_by(step);
      break;
    }
    const std::vector<Vec2> move = system.spread(step);
    const auto lowers = [&](double size, int) {
      std::vector<Vec2> trial = moved(result.flat, size, move);
      const double trial_energy = total_energy(disk, trial);
      if (!(trial_energy <= energy + k_armijo * size * slope)) return false;
      result.flat = std::move(trial);
      energy = trial_energy;
      return true;
    };
    if (!backtrack(first_trial(disk, result.flat, move), k_most_trials, lowers)) {
      result.converged = -slope <= least_fall * energy;  // rounding is all that is left
      break;
    }
    if (after_step) after_step();
  }
  return result;
}

}  // namespace planish
