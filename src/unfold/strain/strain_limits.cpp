#include <algorithm>
#include <cmath>

#include <planish/core/error.h>
#include <planish/core/range.h>
#include <planish/unfold/strain.h>

#include "core/careful_sum.h"
#include "unfold/strain/strain_of_edges.h"

namespace planish {

namespace {

double share_beyond(const std::vector<StrainOfEdge>& edges, double limit) {
  CarefulSum beyond, all;
  for (const StrainOfEdge& edge : edges) {
    all.add(edge.area);
    if (std::abs(edge.strain) > limit) beyond.add(edge.area);
  }
  return all.value() > 0.0 ? beyond.value() / all.value() : 0.0;
}

}  // namespace

void require(const StrainLimits& limits) {
  constexpr Range range = {0.0, k_largest_strain_limit};
  check_range("the limit of strain of every edge", limits.max, range);
  check_range("the limit of strain on 99 % of the area", limits.p99, range);
  check_range("the limit of rms strain", limits.rms, range);
  if (limits.max > 0.0 && limits.p99 > 0.0) {
    throw Error(ErrorCode::option_out_of_range,
                "a limit is of every edge or of 99 % of the area: give one of them");
  }
}

std::string_view to_string(StrainLimitKind kind) {
  switch (kind) {
    case StrainLimitKind::max:
      return "max";
    case StrainLimitKind::p99:
      return "p99";
    case StrainLimitKind::rms:
      return "rms";
  }
  return "unknown";
}

std::vector<StrainLimitCheck> check_limits(const Patch& patch, std::span<const Vec2> pattern,
                                           const StrainLimits& limits) {
  require(limits);
  if (!limits.any()) return {};
  const EdgeStrain strain = edge_strain(patch, pattern);
  const std::vector<StrainOfEdge> edges = strain_of_edges(patch, pattern);
  const auto [v, w] = strain.worst_edge;
  const Vec3 middle = 0.5 * patch.positions()[v] + 0.5 * patch.positions()[w];
  std::vector<StrainLimitCheck> checks;
  const auto add = [&](StrainLimitKind kind, double asked, double reached) {
    if (!(asked > 0.0)) return;
    checks.push_back({kind, asked, reached, share_beyond(edges, asked), strain.worst_edge, middle});
  };
  add(StrainLimitKind::max, limits.max, strain.max);
  add(StrainLimitKind::p99, limits.p99, strain.p99);
  add(StrainLimitKind::rms, limits.rms, strain.rms);
  return checks;
}

bool all_kept(std::span<const StrainLimitCheck> checks) {
  return std::all_of(checks.begin(), checks.end(),
                     [](const StrainLimitCheck& check) { return check.kept(); });
}

}  // namespace planish
