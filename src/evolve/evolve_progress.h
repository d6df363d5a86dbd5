#pragma once

#include <cstddef>

#include <planish/evolve/evolve.h>

namespace planish {

/// How much of an evolution is done, as far as its records tell; for bars of progress. It never
/// goes back. Sweeps count as a share of the most that are allowed; on levels, of which nobody
/// knows how many steps each will take, the vertices of the level do, as steps cost by them: each
/// step takes the share a tenth of the way that is left to what the level's end is worth.
class EvolveProgress {
 public:
  /// @param vertices of the patch
  EvolveProgress(const Stopping& stopping, std::size_t vertices);

  /// The share that is done after one more sweep, 0 to 1.
  double after(const SweepRecord& record);

 private:
  double max_sweeps_, vertices_;
  std::size_t level_ = 0;  // its inner vertices; 0 for the patch without a level
  bool has_levels_ = false;
  double share_ = 0.0, end_ = 0.0;
};

}  // namespace planish
