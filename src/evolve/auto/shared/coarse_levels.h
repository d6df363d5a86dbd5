#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include <planish/evolve/constraints.h>

#include "core/thread_pool.h"
#include "evolve/auto/shared/fairness_energy.h"
#include "evolve/state/patch_state.h"

namespace planish {

/// Coarser and coarser patches over a patch, each over a quarter of the vertices of the one before,
/// down to few. Level 0 is the patch itself.
class CoarseLevels {
 public:
  /// @param small patches of this number of vertices have no coarser level
  /// @param orbits levels are to have them too, where they can: those of the patch, or none
  CoarseLevels(const PatchState& patch, std::size_t small, MirrorOrbits orbits,
               const ThreadPool& pool);

  /// Of the coarsest level; 0 where the patch is small.
  std::size_t coarsest() const { return levels_.size(); }
  /// A level as it was at first, what is fixed held.
  /// @param level from 1
  std::unique_ptr<PatchState> make_state(std::size_t level, ThreadPool& pool) const;
  /// Brings what was found on a level to the next finer one, which is where it was at first:
  /// vertices that both have move alike, the others so that the whole is smooth.
  /// @param level from 1
  /// @param cost of the finer patch
  void lift(std::size_t level, const PatchState& coarse, const FairnessEnergy& cost,
            PatchState& fine, ThreadPool& pool) const;

 private:
  struct Level {
    Patch patch;
    std::vector<Index> source;  ///< vertex -> vertex of the level before
    Constraints constraints;
    MirrorOrbits orbits;
  };
  std::vector<Level> levels_;  // from fine to coarse
};

}  // namespace planish
