#include "evolve/state/sweep.h"

#include <atomic>

namespace planish {

std::size_t visit_all(const VisitPlan& plan, ThreadPool& pool,
                      const std::function<std::size_t(std::size_t, std::size_t)>& body) {
  std::atomic<std::size_t> moved = 0;
  const auto& stage = plan.stage_start;
  for (std::size_t s = 0; s + 1 < stage.size(); ++s) {
    const std::size_t* piece = plan.piece_start.data() + stage[s];
    pool.for_ranges(stage[s + 1] - stage[s], 1, [&](std::size_t first, std::size_t last) {
      moved += body(piece[first], piece[last]);
    });
  }
  return moved;
}

}  // namespace planish
