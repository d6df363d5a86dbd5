#include "flatten/reference_sweeps.h"

#include <algorithm>
#include <variant>

namespace planish {

std::vector<SweepRecord> reference_sweeps(const FlattenReport& report, const Context& context) {
  constexpr int least = 10, most = 50;
  if (std::holds_alternative<ControllableLaplacian>(report.evolve.method)) return {};
  const auto sweeps = static_cast<int>(report.evolve.result.history.size());
  return evolve(report.input, ControllableLaplacian{},
                {.max_sweeps = std::clamp(sweeps, least, most)}, {}, context)
      .history;
}

}  // namespace planish
