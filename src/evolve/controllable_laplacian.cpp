// Controllable Laplacian evolution, Eq. 11-17 of Lin, Zhang, Wang, Gao 2010 with the errata of
// docs/methods/controllable.md: every inner vertex takes the step along its Laplacian vector that
// lowers its ring energy most, and a step is taken only if it lowers it.

#include <cmath>
#include <numbers>

#include <planish/evolve/method.h>

#include "evolve/ring_energy.h"
#include "evolve/sweep.h"

namespace planish {

namespace {

/// Moves one vertex after another; one for each thread.
class ControllableMover {
 public:
  ControllableMover(const ControllableLaplacian& options, PatchState& state)
      : options_(options),
        state_(state),
        radius_(options.max_deviation * state.scale()),
        angle_limit_(options.min_angle * std::numbers::pi / 180.0) {}

  /// True if the vertex found a step.
  bool move(std::size_t v) {
    ring_.look_at(state_, v);
    const double noise = ring_.rounding_error();
    if (ring_.energy() <= noise) return false;  // already flat as far as numbers can tell
    const Vec3 laplacian = ring_.laplacian();
    const Interval steps = within_sphere({options_.lambda_min, options_.lambda_max}, ring_.start(),
                                         laplacian, state_.origin(v), radius_);
    ring_.set_line(laplacian);
    double lambda = minimise_on_line([this](double t) { return ring_.along(t); }, steps).at;
    // Steps of both signs can end in needles: then shorter ones are tried. Without, one try.
    const bool guarded = options_.lambda_min < 0.0;
    for (int tries = guarded ? 8 : 1; tries > 0 && lambda != 0.0; --tries, lambda *= 0.5) {
      const Vec3 target = ring_.start() + lambda * laplacian;
      if (accepts(v, target, guarded, noise)) {
        ring_.move_to(target, state_);
        return true;
      }
    }
    return false;
  }

 private:
  /// The guarantee: what is compared is the energy at the very place that the vertex would get,
  /// and the fall must be more than rounding can feign.
  bool accepts(std::size_t v, Vec3 target, bool guarded, double noise) {
    if (target == ring_.start() || norm(target - state_.origin(v)) > radius_) return false;
    if (guarded && !ring_.keeps_angles(target, angle_limit_)) return false;
    const double energy = ring_.evaluate_at(target);
    return energy < ring_.energy() - noise - ring_.rounding_error();  // false for NaN
  }

  const ControllableLaplacian& options_;
  PatchState& state_;
  double radius_, angle_limit_;
  RingEnergy ring_;
};

}  // namespace

Sweep make_sweep(const ControllableLaplacian& options, PatchState& state, ThreadPool& pool) {
  return [options, &state, &pool] {
    return sweep_by_color(state, pool, [&](std::size_t begin, std::size_t end) {
      ControllableMover mover(options, state);
      std::size_t moved = 0;
      for (std::size_t v = begin; v < end; ++v)
        moved += mover.move(v) ? 1 : 0;
      return moved;
    });
  };
}

}  // namespace planish
