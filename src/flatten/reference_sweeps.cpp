#include "flatten/reference_sweeps.h"

#include <algorithm>
#include <optional>
#include <variant>

namespace planish {

std::vector<SweepRecord> reference_sweeps(const FlattenReport& report, const Context& context) {
  constexpr int least = 10, most = 50;
  const auto& method = report.evolve.method;
  if (!method || std::holds_alternative<ControllableLaplacian>(*method)) return {};
  const auto sweeps = static_cast<int>(report.evolve.result.history.size());
  return evolve(report.input, ControllableLaplacian{},
                {.max_sweeps = std::clamp(sweeps, least, most)}, {}, context)
      .history;
}

}  // namespace planish
