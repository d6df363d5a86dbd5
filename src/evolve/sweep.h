#pragma once

#include <cstddef>
#include <functional>

#include <planish/evolve/method.h>

#include "core/thread_pool.h"
#include "evolve/patch_state.h"

namespace planish {

/// What a pass did.
struct SweepOutcome {
  std::size_t moved = 0;   ///< vertices
  bool converged = false;  ///< the method's own test says that no more can be gained
};

/// One pass of a method over all inner vertices. Positions are what counts when it returns: the
/// evolver computes the defects anew.
using Sweep = std::function<SweepOutcome()>;

/// One per method, each in the source file of its name. State and pool must outlive the sweep.
Sweep make_sweep(const ClassicalLaplacian& options, PatchState& state, ThreadPool& pool);
Sweep make_sweep(const ControllableLaplacian& options, PatchState& state, ThreadPool& pool);
Sweep make_sweep(const FlattenableLaplacian& options, PatchState& state, ThreadPool& pool);
Sweep make_sweep(const LeastNorm& options, PatchState& state, ThreadPool& pool);
Sweep make_sweep(const LocalOffset& options, PatchState& state, ThreadPool& pool);
Sweep make_sweep(const GlobalPenalty& options, PatchState& state, ThreadPool& pool);
Sweep make_sweep(const LocalPerturbation& options, PatchState& state, ThreadPool& pool);

/// Goes through all visits of the plan, the insides of all pieces at the same time, then each
/// colour of seams: body(begin, end) returns how many of the vertices visited it moved. Returns the
/// total.
std::size_t visit_all(const VisitPlan& plan, ThreadPool& pool,
                      const std::function<std::size_t(std::size_t, std::size_t)>& body);

/// Closed interval.
struct Interval {
  double low = 0.0, high = 0.0;
};

/// The part of an interval of steps from x along `direction` that stays within `radius` of origin.
/// Always holds 0.
Interval within_sphere(Interval steps, Vec3 x, Vec3 direction, Vec3 origin, double radius);

}  // namespace planish
