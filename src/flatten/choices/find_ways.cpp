#include "flatten/choices/find_ways.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <utility>

#include <planish/measure/material.h>

#include "core/job.h"
#include "core/neumaier_sum.h"

namespace planish {

namespace {

// With fewer, moves come out as well, but more folds do, and more forms count as kept.
constexpr std::size_t k_coarse_vertices = 250;
constexpr std::array k_rms_limits = {0.02, 0.01, 0.005};

/// Whether what was asked for is one thing: what a material takes, or one limit.
bool is_one_way(const StrainLimits& limits, const std::string& material) {
  if (!material.empty()) return limits.rms == 0.0;
  return check_limits(EdgeStrain{}, limits).size() == 1;
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

/// The rms distance of two surfaces over the area of the first, where moves are linear on
/// triangles. That of inner vertices says too much of a coarse mesh, as none is near the border.
double rms_move(const Patch& patch, std::span<const Vec3> after) {
  const double scale = patch.unit_scale();
  const auto at = [&](Index v) { return scale * patch.positions()[v]; };
  const auto move = [&](Index v) { return scale * after[v] - at(v); };
  NeumaierSum squares, area;
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
  if (patch.vertex_count() > k_most_vertices_of_ways) return {};
  std::vector<Way> ways = missed_limits(design.now);
  if (ways.empty()) return ways;
  ThreadPool pool(context);
  const std::optional<CoarseJob> coarse =
      coarse_job(patch, options, k_coarse_vertices, design, pool, context);
  if (!coarse) return {};
  std::vector<unsigned char> is_known(ways.size(), 0);
  pool.for_ranges(ways.size(), 1, [&](std::size_t k, std::size_t end) {
    for (; k < end; ++k) {
      FlattenOptions job = coarse->options;
      job.limits = coarse->strain.scaled(ways[k].limits);
      try {
        ways[k] = estimated(std::move(ways[k]), run(coarse->patch, job, alone_with(context)),
                            coarse->strain);
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
  for (const LimitCheck& check : report.unfold.limits)
    asked.of(check.what) = check.limit;
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
