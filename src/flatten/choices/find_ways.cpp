#include "flatten/choices/find_ways.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <utility>

#include <planish/unfold/material_fit.h>

#include "core/careful_sum.h"
#include "core/job.h"
#include "mesh/coarsen/coarsen.h"

namespace planish {

namespace {

// With fewer, moves come out as well, but more folds do, and more forms count as kept.
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

/// How many times the strain of the design its coarse mesh has. Limits are as many times as large
/// there, so that the same share of the strain goes.
struct CoarseStrain {
  double of_edges = 1.0, rms = 1.0;

  /// @throws Error if the coarse mesh has no pattern
  CoarseStrain(const Patch& coarse, const FlattenOptions& how, const StrainOfDesign& design,
               const Context& context) {
    // What a coarse mesh lacks of the strain is fine, as noise is: that goes with hardly a move.
    // But its edges leave out some of a peak too.
    constexpr double least_of_edges = 0.7, least_rms = 1.0;
    const bool is_spread = design.now.p99 != design.least.p99;
    const UnfoldReport report =
        unfold_patch(coarse, how.unit, {.least_stretch = !is_spread, .fold = how.fold}, context);
    const EdgeStrain least = report.unlimited_strain.value_or(report.strain);
    if (design.now.p99 > 0.0)
      of_edges = std::max(least_of_edges, report.strain.p99 / design.now.p99);
    if (design.least.rms > 0.0) rms = std::max(least_rms, least.rms / design.least.rms);
  }

  StrainLimits scaled(StrainLimits limits) const {
    for (const StrainLimitKind kind : k_strain_limit_kinds) {
      const double scale = kind == StrainLimitKind::rms ? rms : of_edges;
      limits.of(kind) = std::min(scale * limits.of(kind), k_largest_strain_limit);
    }
    return limits;
  }

  EdgeStrain scaled_back(EdgeStrain strain) const {
    for (double* figure : {&strain.max, &strain.p99, &strain.max_stretch, &strain.p99_stretch,
                           &strain.max_compression, &strain.p99_compression})
      *figure /= of_edges;
    strain.rms /= rms;
    return strain;
  }
};

/// The rms distance of two surfaces over the area of the first, where moves are linear on
/// triangles. That of inner vertices says too much of a coarse mesh, as none is near the border.
double rms_move(const Patch& patch, std::span<const Vec3> after) {
  const double scale = patch.unit_scale();
  const auto at = [&](Index v) { return scale * patch.positions()[v]; };
  const auto move = [&](Index v) { return scale * after[v] - at(v); };
  CarefulSum squares, area;
  for (const Triangle& t : patch.triangles()) {
    const double doubled = norm(cross(at(t[1]) - at(t[0]), at(t[2]) - at(t[0])));
    const Vec3 a = move(t[0]), b = move(t[1]), c = move(t[2]);
    squares.add(doubled * (dot(a, a) + dot(b, b) + dot(c, c) + dot(a, b) + dot(b, c) + dot(c, a)));
    area.add(6.0 * doubled);
  }
  return area.value() > 0.0 ? std::sqrt(squares.value() / area.value()) / scale : 0.0;
}

Way taken(Way way, const FlattenReport& report) {
  way.reached = all_kept(report.unfold.limits) && !report.unfold.limits.empty() &&
                !report.unfold.pattern.overlaps;
  way.strain = report.unfold.strain;
  way.deviation = report.evolve.deviation;
  way.fairness = report.evolve.fairness;
  return way;
}

Way estimated(Way way, const FlattenReport& tried, const CoarseStrain& strain) {
  way = taken(std::move(way), tried);
  way.strain = strain.scaled_back(way.strain);
  way.deviation.rms = rms_move(tried.input, tried.processed.positions());
  return way;
}

}  // namespace

std::vector<Way> find_ways(const Patch& patch, const FlattenOptions& options,
                           const StrainOfDesign& design, const CoarseRun& run,
                           const Context& context) {
  const Constraints& given = options.constraints;
  if (!given.fixed.empty() || !given.weights.empty() || !given.obstacle.triangles.empty() ||
      patch.vertex_count() > k_most_vertices_of_ways || !can_be_coarsened(patch)) {
    return {};
  }
  std::vector<Way> ways = missed_limits(design.now);
  if (ways.empty()) return ways;
  ThreadPool pool(context);
  const auto [coarse, how] = coarse_job(patch, options, pool);
  Context alone = context;
  alone.on_progress = {};
  alone.threads = 1;
  std::optional<CoarseStrain> strain;
  try {
    strain.emplace(coarse, how, design, alone);
  } catch (const Error&) {
    return {};  // a mesh so coarse may have no pattern where the design has one
  }
  std::vector<unsigned char> is_known(ways.size(), 0);
  pool.for_ranges(ways.size(), 1,
                  [&, &coarse = coarse, &how = how](std::size_t k, std::size_t end) {
                    for (; k < end; ++k) {
                      FlattenOptions job = how;
                      job.limits = strain->scaled(ways[k].limits);
                      try {
                        ways[k] = estimated(std::move(ways[k]), run(coarse, job, alone), *strain);
                        is_known[k] = 1;
                      } catch (const Error&) {
                        // There is no estimate.
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
