#pragma once

#include <limits>
#include <optional>
#include <vector>

#include <planish/evolve/evolver.h>

#include "core/thread_pool.h"
#include "evolve/methods/controllable_laplacian.h"
#include "evolve/state/sweep.h"
#include "oracle/plain_sweep.h"
#include "support/stopwatch.h"

namespace planish::bench {

/// Medians of ten controllable sweeps, seconds: colouring, renumbering and the defects after every
/// sweep included, connectivity and inspection not.
struct SweepTimes {
  double plain = 0.0, one_thread = 0.0, two_threads = 0.0;
};

constexpr int k_sweeps = 10;

// What frees memory is not counted: the states outlive the clock.
inline double ten_sweeps(const Patch& patch, unsigned threads) {
  ThreadPool pool(threads);
  std::optional<PatchState> state;
  return seconds_of([&] {
    state.emplace(patch, pool);
    const Sweep sweep = make_sweep(ControllableLaplacian{}, *state, pool);
    for (int i = 0; i < k_sweeps; ++i) {
      sweep();
      state->measure(pool);
    }
  });
}

inline double ten_plain_sweeps(const Patch& patch) {
  std::optional<plain::Sweeper> sweeper;
  return seconds_of([&] {
    sweeper.emplace(patch.positions(), patch.connectivity());
    for (int i = 0; i < k_sweeps; ++i)
      sweeper->sweep(patch.inner_vertices(), {0.0, 1.0}, 1e-17);
  });
}

/// The three in turn, so that a slow moment of the machine falls on all of them.
/// @param plain_repetitions of the plain sweeps alone, which take long; at most as many as the rest
inline SweepTimes time_sweeps(const TriMesh& mesh, int plain_repetitions = 5) {
  constexpr int repetitions = 5;
  const Patch patch(mesh);
  std::vector<double> plain, one, two;
  for (int i = 0; i < repetitions; ++i) {
    if (i < plain_repetitions) plain.push_back(ten_plain_sweeps(patch));
    one.push_back(ten_sweeps(patch, 1));
    two.push_back(ten_sweeps(patch, 2));
  }
  return {median(plain), median(one), median(two)};
}

}  // namespace planish::bench
