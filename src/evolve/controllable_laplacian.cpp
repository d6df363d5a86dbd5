// Controllable Laplacian evolution, Eq. 11-17 of Lin, Zhang, Wang, Gao 2010 with the errata of
// docs/methods/controllable.md: every inner vertex takes the step along its Laplacian vector that
// lowers its ring energy most, and a step is taken only if it lowers it.

#include "evolve/controllable_laplacian.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "evolve/sweep.h"

namespace planish {

namespace {

/// Stars that are handed to the kernel together.
constexpr std::size_t k_batch = 128;

}  // namespace

ControllableMover::ControllableMover(const ControllableLaplacian& options, PatchState& state,
                                     Isa isa)
    : state_(state), move_stars_(move_stars_for(isa)), idle_since_(state.inner_count(), 0) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  // Steps of one sign make no needles by themselves.
  const double limit = options.lambda_min < 0.0 ? options.min_angle * std::numbers::pi / 180.0 : -1;
  options_ = {.lambda_min = options.lambda_min,
              .lambda_max = options.lambda_max,
              .max_cotangent = limit > 0.0 ? 1.0 / std::tan(limit) : inf,
              .radius = options.max_deviation * state.scale(),
              .origins = nullptr};
  if (options_.radius < inf) {
    origins_.assign(state.sites().begin(), state.sites().end());
    options_.origins = origins_.data();
  }
}

std::size_t ControllableMover::move(std::size_t begin, std::size_t end) {
  std::array<Star, k_batch> stars;
  std::size_t moved = 0;
  while (begin < end) {
    const std::size_t run_end = std::min(end, state_.end_of_run(begin));
    const std::size_t valence = state_.ring(state_.visited(begin)).size();
    while (begin < run_end) {
      std::size_t count = 0;
      for (; begin < run_end && count < k_batch; ++begin) {
        const Index v = state_.visited(begin);
        const std::uint32_t idle = idle_since_[v];
        if (idle != 0 && !state_.ring_changed_since(idle, v)) continue;
        stars[count++] = {state_.ring(v).data(), v};
      }
      moved += move_batch({stars.data(), count}, valence);
    }
  }
  return moved;
}

std::size_t ControllableMover::move_batch(std::span<const Star> stars, std::size_t valence) {
  std::array<unsigned char, k_batch> moved;
  move_stars_(options_, state_.sites().data(), state_.inner_count(), stars.data(), stars.size(),
              valence, moved.data());
  std::size_t total = 0;
  for (std::size_t i = 0; i < stars.size(); ++i) {
    idle_since_[stars[i].center] = moved[i] != 0 ? 0 : state_.now();
    if (moved[i] == 0) continue;
    state_.note_move(stars[i].center);
    ++total;
  }
  return total;
}

Sweep make_sweep(const ControllableLaplacian& options, PatchState& state, ThreadPool& pool) {
  return [mover = ControllableMover(options, state), &state, &pool]() mutable {
    return sweep_by_color(
        state, pool, [&](std::size_t begin, std::size_t end) { return mover.move(begin, end); });
  };
}

}  // namespace planish
