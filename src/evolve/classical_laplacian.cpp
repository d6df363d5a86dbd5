// Classical Laplacian evolution, Eq. 9-10 of Lin, Zhang, Wang, Gao 2010: v <- v + lambda L(v) with
// weights proportional to the lengths of the edges and one lambda for all.

#include <algorithm>

#include <planish/evolve/method.h>

#include "evolve/laplacian.h"
#include "evolve/sweep.h"

namespace planish {

namespace {

Vec3 laplacian_at(const PatchState& state, std::size_t v) {
  const auto ring = state.ring(v);
  return edge_weighted_laplacian(state.position(v), ring.size(),
                                 [&](std::size_t j) { return state.position(ring[j]); });
}

/// Where the vertex goes: lambda L(v) further, or as far that way as the deviation allows.
Vec3 target_of(const PatchState& state, std::size_t v, const ClassicalLaplacian& options) {
  const double radius = options.max_deviation * state.scale();
  const Vec3 x = state.position(v), laplacian = laplacian_at(state, v), origin = state.origin(v);
  const Interval steps = within_sphere({0.0, options.lambda}, x, laplacian, origin, radius);
  const Vec3 target = x + steps.high * laplacian;
  // Nor onto a neighbour: an edge of length zero has no angles.
  const auto ring = state.ring(v);
  const bool joins =
      std::any_of(ring.begin(), ring.end(), [&](Index j) { return state.position(j) == target; });
  return norm(target - origin) <= radius && !joins ? target : x;
}

std::size_t move_to(PatchState& state, std::size_t v, Vec3 target) {
  if (target == state.position(v)) return 0;
  state.move(v, target);
  return 1;
}

}  // namespace

Sweep make_sweep(const ClassicalLaplacian& options, PatchState& state, ThreadPool& pool) {
  if (options.order == SweepOrder::sequential) {
    return [options, &state, &pool] {
      return sweep_by_color(state, pool, [&](std::size_t begin, std::size_t end) {
        std::size_t moved = 0;
        for (std::size_t i = begin; i < end; ++i) {
          const Index v = state.visited(i);
          moved += move_to(state, v, target_of(state, v, options));
        }
        return moved;
      });
    };
  }
  return [options, &state, &pool, targets = std::vector<Vec3>(state.inner_count())]() mutable {
    pool.for_ranges(targets.size(), 64, [&](std::size_t begin, std::size_t end) {
      for (std::size_t v = begin; v < end; ++v)
        targets[v] = target_of(state, v, options);
    });
    std::size_t moved = 0;
    for (std::size_t v = 0; v < targets.size(); ++v)
      moved += move_to(state, v, targets[v]);
    return moved;
  };
}

}  // namespace planish
