#include "flatten/choices/find_ways.h"

#include <algorithm>
#include <array>
#include <utility>

#include <planish/measure/material.h>

#include "core/job.h"
#include "mesh/coarsen/coarsen.h"

namespace planish {

namespace {

// So many vertices tell a move to about a fifth of itself, in some 30 ms a way.
constexpr std::size_t k_coarse_vertices = 250;
constexpr std::array k_rms_limits = {0.02, 0.01, 0.005};

/// What could be asked for and is missed.
std::vector<Way> missed_limits(const EdgeStrain& design) {
  std::vector<Way> ways;
  for (const Material& material : materials()) {
    if (!(design.p99 > material.max_strain)) continue;
    Way way;
    way.limits.p99 = material.max_strain;
    way.material = material.name;
    const auto is_same = [&](const Way& other) { return other.limits == way.limits; };
    if (std::none_of(ways.begin(), ways.end(), is_same)) ways.push_back(std::move(way));
  }
  std::stable_sort(ways.begin(), ways.end(),
                   [](const Way& a, const Way& b) { return a.limits.p99 > b.limits.p99; });
  ways.resize(std::min(ways.size(), k_most_ways - k_rms_limits.size()));
  for (const double limit : k_rms_limits) {
    if (!(design.rms > limit)) continue;
    Way way;
    way.limits.rms = limit;
    ways.push_back(std::move(way));
  }
  return ways;
}

/// The patch with few vertices, and the ends of its fold among them.
std::pair<Patch, FlattenOptions> coarse_job(const Patch& patch, const FlattenOptions& options,
                                            const ThreadPool& pool) {
  FlattenOptions how;
  how.as_needed = options.as_needed;
  how.unit = options.unit;
  std::vector<unsigned char> keep;
  if (options.fold) {
    keep.assign(patch.vertex_count(), 0);
    for (const Index v : *options.fold)
      keep[v] = 1;
  }
  CoarsePatch coarse = coarsen(patch, k_coarse_vertices, CoarseBorder::thinned, keep, &pool);
  if (options.fold) {
    how.fold = {};
    std::array<Index, 2> ends = *options.fold;
    for (Index& v : ends) {
      const auto found = std::lower_bound(coarse.source.begin(), coarse.source.end(), v);
      v = static_cast<Index>(found - coarse.source.begin());
    }
    how.fold = ends;
  }
  return {Patch(std::move(coarse.mesh)), how};
}

Way taken(Way way, const FlattenReport& report) {
  way.reached = all_kept(report.unfold.limits) && !report.unfold.limits.empty() &&
                !report.unfold.pattern.overlaps;
  way.strain = report.unfold.strain;
  way.deviation = report.evolve.deviation;
  way.fairness = report.evolve.fairness;
  return way;
}

bool has_one_kind(const StrainLimits& limits) {
  return (limits.max > 0.0) + (limits.p99 > 0.0) + (limits.rms > 0.0) == 1;
}

}  // namespace

std::vector<Way> find_ways(const Patch& patch, const FlattenOptions& options,
                           const EdgeStrain& design, const Context& context) {
  const Constraints& given = options.constraints;
  if (!given.fixed.empty() || !given.weights.empty() || !given.obstacle.triangles.empty() ||
      patch.vertex_count() > k_most_vertices_of_ways || !can_be_coarsened(patch)) {
    return {};
  }
  std::vector<Way> ways = missed_limits(design);
  if (ways.empty()) return ways;
  ThreadPool pool(context);
  auto [coarse, how] = coarse_job(patch, options, pool);
  Context quiet = context;
  quiet.on_progress = {};
  std::vector<Way> found;
  found.reserve(ways.size());
  for (Way& way : ways) {
    how.limits = way.limits;
    try {
      found.push_back(taken(std::move(way), flatten(coarse, {}, how, quiet)));
    } catch (const Error&) {
      // A mesh so coarse may have no pattern where the design has one: there is no estimate then.
    }
  }
  return found;
}

std::vector<Way> with_result(std::vector<Way> ways, const FlattenReport& report) {
  StrainLimits asked;
  for (const StrainLimitCheck& check : report.unfold.limits) {
    (check.kind == StrainLimitKind::max   ? asked.max
     : check.kind == StrainLimitKind::p99 ? asked.p99
                                          : asked.rms) = check.asked;
  }
  if (!has_one_kind(asked)) return ways;
  Way result;
  result.limits = asked;
  result.material = report.material;
  result.estimated = false;
  result = taken(std::move(result), report);
  const auto same =
      std::find_if(ways.begin(), ways.end(), [&](const Way& way) { return way.limits == asked; });
  if (same != ways.end()) {
    *same = std::move(result);
  } else {
    ways.insert(ways.begin(), std::move(result));
  }
  return ways;
}

}  // namespace planish
