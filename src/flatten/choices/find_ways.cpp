#include "flatten/choices/find_ways.h"

#include <algorithm>
#include <array>
#include <utility>

#include <planish/unfold/material_fit.h>

#include "core/job.h"
#include "mesh/coarsen/coarsen.h"

namespace planish {

namespace {

// So many vertices tell a move to about a fifth of itself, in some 30 ms a way.
constexpr std::size_t k_coarse_vertices = 250;
constexpr std::array k_rms_limits = {0.02, 0.01, 0.005};

/// Whether what was asked for is one thing: what a material takes, or one limit.
bool is_one_way(const StrainLimits& limits, const std::string& material) {
  if (!material.empty()) return limits.rms == 0.0;
  return std::count_if(k_strain_limit_kinds.begin(), k_strain_limit_kinds.end(),
                       [&](StrainLimitKind kind) { return limits.of(kind) > 0.0; }) == 1;
}

/// What could be asked for and is missed.
std::vector<Way> missed_limits(const EdgeStrain& design) {
  std::vector<Way> ways;
  for (const Material& material : materials()) {
    Way way;
    way.limits = limits_of(material);
    way.material = material.name;
    if (way.limits.kept_by(design)) continue;
    const auto is_same = [&](const Way& other) { return other.limits == way.limits; };
    if (std::none_of(ways.begin(), ways.end(), is_same)) ways.push_back(std::move(way));
  }
  std::stable_sort(ways.begin(), ways.end(),
                   [](const Way& a, const Way& b) { return a.limit() > b.limit(); });
  if (constexpr std::size_t most = k_most_ways - k_rms_limits.size(); ways.size() > most)
    ways = {ways.front(), ways[ways.size() / 2], ways.back()};
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
  const auto [coarse, how] = coarse_job(patch, options, pool);
  Context alone = context;
  alone.on_progress = {};
  alone.threads = 1;
  std::vector<unsigned char> is_known(ways.size(), 0);
  pool.for_ranges(ways.size(), 1,
                  [&, &coarse = coarse, &how = how](std::size_t k, std::size_t end) {
                    for (; k < end; ++k) {
                      FlattenOptions job = how;
                      job.limits = ways[k].limits;
                      try {
                        ways[k] = taken(std::move(ways[k]), flatten(coarse, {}, job, alone));
                        is_known[k] = 1;
                      } catch (const Error&) {
                        // A mesh so coarse may have no pattern where the design has one: then there
                        // is no estimate.
                      }
                    }
                  });
  std::vector<Way> known;
  for (std::size_t k = 0; k < ways.size(); ++k) {
    if (is_known[k] != 0) known.push_back(std::move(ways[k]));
  }
  return known;
}

std::vector<Way> with_result(std::vector<Way> ways, const FlattenReport& report) {
  StrainLimits asked;
  for (const StrainLimitCheck& check : report.unfold.limits)
    asked.of(check.kind) = check.asked;
  if (!is_one_way(asked, report.material)) return ways;
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
