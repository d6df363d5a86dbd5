// Controllable Laplacian evolution, Eq. 11-17 of Lin, Zhang, Wang, Gao 2010 with the errata of
// docs/methods/controllable.md: every inner vertex takes the step along its Laplacian vector that
// lowers its ring energy most, and a step is taken only if it lowers it.

#include <cmath>
#include <numbers>

#include <planish/evolve/method.h>

#include "evolve/controllable_mover.h"
#include "evolve/sweep.h"

namespace planish {

ControllableMover::ControllableMover(const ControllableLaplacian& options, PatchState& state)
    : options_(options),
      state_(state),
      radius_(options.max_deviation * state.scale()),
      angle_limit_(options.min_angle * std::numbers::pi / 180.0),
      guarded_(options.lambda_min < 0.0) {}

bool ControllableMover::move(std::size_t v) {
  ring_.look_at(state_, v);
  const double error = ring_.rounding_error();
  if (ring_.energy() <= error) return false;  // flat as far as numbers can tell
  const Vec3 laplacian = ring_.laplacian();
  const Interval steps = within_sphere({options_.lambda_min, options_.lambda_max}, ring_.start(),
                                       laplacian, state_.origin(v), radius_);
  ring_.set_line(laplacian);
  double lambda = minimise_on_line([this](double t) { return ring_.along(t); }, steps).at;
  // Steps of both signs can end in needles: then shorter ones are tried. Without, one try.
  for (int tries = guarded_ ? 8 : 1; tries > 0 && lambda != 0.0; --tries, lambda *= 0.5) {
    const Vec3 target = ring_.start() + lambda * laplacian;
    if (!accepts(v, target, ring_.energy() - error)) continue;
    ring_.move_to(target, state_);
    return true;
  }
  return false;
}

/// The guarantee: what is compared is the energy at the very place that the vertex would get, and
/// the fall must be more than rounding can feign.
bool ControllableMover::accepts(std::size_t v, Vec3 target, double enough) {
  if (target == ring_.start() || norm(target - state_.origin(v)) > radius_) return false;
  if (!ring_.keeps_lengths(target)) return false;
  if (guarded_ && !ring_.keeps_angles(target, angle_limit_)) return false;
  const double energy = ring_.evaluate_at(target);
  return energy + ring_.rounding_error() < enough;  // false for NaN
}

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
