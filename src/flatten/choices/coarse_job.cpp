#include "flatten/choices/coarse_job.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "mesh/coarsen/coarsen.h"

namespace planish {

namespace {

bool names_vertices(const Constraints& given) {
  return !given.fixed.empty() || !given.weights.empty() || !given.obstacle.triangles.empty();
}

/// The patch with few vertices, and the ends of its fold among them.
CoarseJob coarsened(const Patch& patch, const FlattenOptions& options, std::size_t vertices,
                    const ThreadPool& pool) {
  std::vector<unsigned char> keep;
  if (options.fold) {
    keep.assign(patch.vertex_count(), 0);
    for (const Index v : *options.fold)
      keep[v] = 1;
  }
  CoarsePatch coarse = coarsen(patch, vertices, CoarseBorder::thinned, keep, &pool);
  CoarseJob job{Patch(std::move(coarse.mesh)), {}, {}};
  job.options.method = options.method;
  job.options.as_needed = options.as_needed;
  job.options.unit = options.unit;
  if (options.fold) {
    std::array<Index, 2> ends = *options.fold;
    for (Index& v : ends) {
      const auto found = std::lower_bound(coarse.source.begin(), coarse.source.end(), v);
      v = static_cast<Index>(found - coarse.source.begin());
    }
    job.options.fold = ends;
  }
  return job;
}

/// @throws Error if the coarse mesh has no pattern
CoarseStrain coarse_strain(const CoarseJob& job, const StrainOfDesign& design,
                           const Context& context) {
  // What a coarse mesh lacks of the strain is fine, as noise is: that goes with hardly a move.
  // But its edges leave out some of a peak too.
  constexpr double least_of_edges = 0.7, least_rms = 1.0;
  const bool is_spread = design.now.p99 != design.least.p99;
  const UnfoldReport report =
      unfold_patch(job.patch, job.options.unit,
                   {.least_stretch = !is_spread, .fold = job.options.fold}, context);
  const EdgeStrain least = report.unlimited_strain.value_or(report.strain);
  CoarseStrain strain;
  if (design.now.p99 > 0.0)
    strain.of_edges = std::max(least_of_edges, report.strain.p99 / design.now.p99);
  if (design.least.rms > 0.0) strain.rms = std::max(least_rms, least.rms / design.least.rms);
  return strain;
}

}  // namespace

StrainLimits CoarseStrain::scaled(StrainLimits limits) const {
  for (const Criterion what : k_strain_criteria) {
    const double scale = what == Criterion::rms_strain ? rms : of_edges;
    limits.of(what) = std::min(scale * limits.of(what), k_largest_strain_limit);
  }
  return limits;
}

EdgeStrain CoarseStrain::scaled_back(EdgeStrain strain) const {
  for (double* figure : {&strain.max, &strain.p99, &strain.max_stretch, &strain.p99_stretch,
                         &strain.max_compression, &strain.p99_compression})
    *figure /= of_edges;
  strain.rms /= rms;
  return strain;
}

std::optional<CoarseJob> coarse_job(const Patch& design, const FlattenOptions& options,
                                    std::size_t vertices, const StrainOfDesign& strain,
                                    const ThreadPool& pool, const Context& context) {
  if (names_vertices(options.constraints) || !can_be_coarsened(design)) return std::nullopt;
  CoarseJob job = coarsened(design, options, vertices, pool);
  try {
    job.strain = coarse_strain(job, strain, alone_with(context));
  } catch (const Error&) {
    return std::nullopt;  // a mesh so coarse may have no pattern where the design has one
  }
  return job;
}

Context alone_with(Context context) {
  context.on_progress = {};
  context.threads = 1;
  return context;
}

}  // namespace planish
