#pragma once

#include <cstddef>

#include <planish/evolve/evolve.h>

namespace planish {

/// How much of an evolution is done, as far as its records tell; for bars of progress. It never
/// goes back. Sweeps count as a share of the most that are allowed. A level counts by its vertices,
/// as its steps cost by them. How many steps it will take is not known: each takes a tenth of what
/// is left of the first level, three tenths of what is left of a finer one. Before its first step a
/// level is opened, which takes two fifths of it.
class EvolveProgress {
 public:
  /// @param vertices of the patch
  EvolveProgress(const Stopping& stopping, std::size_t vertices);

  /// The share that is done when that much, 0 to 1, of the opening of the next level is done.
  double while_opening(double share);

  /// The share that is done after one more sweep, 0 to 1.
  double after(const SweepRecord& record);

 private:
  double max_sweeps_, vertices_;
  std::size_t level_ = 0;  // its inner vertices; 0 for the patch without a level
  bool has_levels_ = false;
  double share_ = 0.0, end_ = 0.0;  // now, and at the end of the level
  double of_rest_ = 0.1;            // of the level, what a step takes
};

}  // namespace planish
