#pragma once

#include <string_view>
#include <vector>

#include <planish/core/context.h>
#include <planish/evolve/evolver.h>

namespace planish {

/// When to end, besides when nothing moves any more.
struct Stopping {
  int max_sweeps = 10;
  double target_e_max = 0.0;  ///< radians
};

/// Calls visit(name, member, words, range) for both, as describe() of a method does.
template <class Visit>
void describe(Stopping& o, Visit&& visit) {
  visit("sweeps", o.max_sweeps, "at most so many passes over all inner vertices", Range{0.0, 1e9});
  visit("target_e_max", o.target_e_max, "end as soon as e_max is at most this, in radians",
        Range{0.0});
}

/// What an evolution ends with.
struct EvolveResult {
  std::vector<Vec3> positions;                ///< one per vertex of the mesh, in its order
  std::vector<SweepRecord> history;           ///< one per sweep
  StopReason stop = StopReason::sweep_limit;  ///< why it ended
  unsigned threads = 1;                       ///< that were in use
  double seconds = 0.0;                       ///< of wall-clock time
};

/// Moves the inner vertices of a patch so that it gets closer to flattenable; triangles stay, and
/// the border unless GlobalPenalty::border or Auto::border says otherwise. A patch that already
/// meets the target is returned unchanged, bit for bit.
/// To look at the surface after each sweep, or to end early and keep it, use Evolver.
/// @throws Error option_out_of_range, as check_constraints(), or what stands in the way of
/// Purpose::evolve; Cancelled
EvolveResult evolve(const Patch& patch, const Method& method = ControllableLaplacian{},
                    const Stopping& stopping = {}, const Constraints& constraints = {},
                    const Context& context = {});

/// When to end where nobody said: after as many sweeps as the method usually takes.
Stopping usual_stopping(const Method& method);

}  // namespace planish
