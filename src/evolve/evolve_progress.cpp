#include "evolve/evolve_progress.h"

#include <algorithm>

namespace planish {

EvolveProgress::EvolveProgress(const Stopping& stopping, std::size_t vertices)
    : max_sweeps_(static_cast<double>(stopping.max_sweeps)),
      vertices_(static_cast<double>(vertices)) {}

double EvolveProgress::while_opening(double share) {
  constexpr double of_level = 0.4, thinning = 4.0, first_level = 0.1;
  const double end = end_ > 0.0 ? std::min(1.0, thinning * end_) : first_level;
  const double done = end_ + of_level * std::clamp(share, 0.0, 1.0) * (end - end_);
  return share_ = std::max(share_, std::min(done, 1.0));
}

double EvolveProgress::after(const SweepRecord& record) {
  if (record.level || has_levels_) {
    const std::size_t level = record.level ? record.level->inner_vertices : 0;
    if (!has_levels_ || level != level_) {
      // Finer levels take some five steps where the first takes some twenty.
      of_rest_ = has_levels_ ? 0.3 : 0.1;
      share_ = std::max(share_, end_);
      end_ = record.level ? static_cast<double>(level) / vertices_ : 1.0;
      level_ = level;
      has_levels_ = true;
    }
    share_ += of_rest_ * std::max(0.0, end_ - share_);
  }
  share_ = std::max(share_, static_cast<double>(record.sweep) / max_sweeps_);
  return share_ = std::min(share_, 1.0);
}

}  // namespace planish
