// Classical Laplacian evolution, Eq. 9-10 of Lin, Zhang, Wang, Gao 2010: v <- v + lambda L(v) with
// weights proportional to the lengths of the edges and one lambda for all.

#include <algorithm>
#include <span>

#include <planish/evolve/method.h>

#include "evolve/state/sweep.h"
#include "evolve/vertex_step/interval.h"
#include "geometry/laplacian.h"

namespace planish {

namespace {

/// Where the vertex goes: lambda L(v) further, or as far that way as the deviation allows.
Vec3 target_of(const PatchState& state, Index v, std::span<const Index> ring,
               const ClassicalLaplacian& options) {
  if (state.is_fixed(v)) return state.position(v);
  const double radius = options.max_deviation * state.scale();
  const Vec3 x = state.position(v), origin = state.origin(v);
  const Vec3 laplacian = edge_weighted_laplacian(
      x, ring.size(), [&](std::size_t j) { return state.position(ring[j]); });
  const Interval steps = within_sphere({0.0, options.lambda}, x, laplacian, origin, radius);
  const Vec3 target = x + steps.high * laplacian;
  // Nor onto a neighbour: an edge of length zero has no angles.
  const bool joins =
      std::any_of(ring.begin(), ring.end(), [&](Index j) { return state.position(j) == target; });
  return norm(target - origin) <= radius && !joins ? target : x;
}

std::size_t move_to(PatchState& state, Index v, Vec3 target) {
  if (target == state.position(v)) return 0;
  state.move(v, target);
  return 1;
}

/// Calls body(vertex, its ring) for the visits from begin to end - 1.
template <class Body>
void for_visits(const VisitPlan& plan, std::size_t begin, std::size_t end, const Body& body) {
  plan.for_runs(begin, end, [&](const Run& run, std::size_t i, std::size_t last) {
    for (; i < last; ++i)
      body(plan.visits[i], plan.ring(run, i));
  });
}

}  // namespace

Sweep make_sweep(const ClassicalLaplacian& options, PatchState& state, ThreadPool& pool) {
  const VisitPlan& plan = state.plan();
  if (options.order == SweepOrder::sequential) {
    return [options, &state, &plan, &pool] {
      return SweepOutcome{visit_all(plan, pool, [&](std::size_t begin, std::size_t end) {
        std::size_t moved = 0;
        for_visits(plan, begin, end, [&](Index v, std::span<const Index> ring) {
          moved += move_to(state, v, target_of(state, v, ring, options));
        });
        return moved;
      })};
    };
  }
  return
      [options, &state, &plan, &pool, targets = std::vector<Vec3>(state.inner_count())]() mutable {
        pool.for_ranges(targets.size(), 64, [&](std::size_t begin, std::size_t end) {
          for_visits(plan, begin, end, [&](Index v, std::span<const Index> ring) {
            targets[v] = target_of(state, v, ring, options);
          });
        });
        std::size_t moved = 0;
        for (Index v = 0; v < targets.size(); ++v)
          moved += move_to(state, v, targets[v]);
        return SweepOutcome{moved};
      };
}

}  // namespace planish
