#include "flatten/steps/unfold_patch.h"

#include <atomic>
#include <future>
#include <vector>

#include "core/async_task.h"
#include "core/job.h"

namespace planish {

UnfoldReport unfold_patch(const Patch& patch, Unit unit, const UnfoldOptions& wanted,
                          const Context& context) {
  UnfoldOptions options = wanted;
  options.open_crossings = k_hair / millimetres_per(unit);
  UnfoldReport report;
  report.unit = unit;
  report.pattern = unfold(patch, options, context);
  report.overlap = overlap_of(patch, report.pattern);
  const auto strain_of = [&](const std::vector<Vec2>& positions) {
    return edge_strain(patch, positions);
  };
  report.strain = strain_of(report.pattern.positions);
  report.border_strain = largest_border_strain(patch, report.pattern.positions, options.free_edges);
  if (!report.pattern.unmatched_least_stretch.empty())
    report.unmatched_strain = strain_of(report.pattern.unmatched_least_stretch);
  if (!report.pattern.least_stretch.empty())
    report.unlimited_strain = strain_of(report.pattern.least_stretch);
  report.limits = check_limits(patch, report.pattern.positions, options.limits);
  return report;
}

std::pair<UnfoldReport, UnfoldReport> unfold_both(const Patch& before, const Patch& after,
                                                  Unit unit, const UnfoldOptions& how, bool at_once,
                                                  const Context& context) {
  std::atomic<bool> abandoned = false;
  Context quiet = context;
  quiet.on_progress = {};
  quiet.is_cancelled = [&] {
    return abandoned || (context.is_cancelled && context.is_cancelled());
  };
  UnfoldOptions plain;
  plain.least_stretch = how.least_stretch;
  plain.fold = how.fold;
  plain.symmetric_in = how.symmetric_in;
  const auto unfold_before = [&] { return unfold_patch(before, unit, plain, quiet); };
  PartsOfJob parts(context);
  if (!at_once) {
    UnfoldReport second = unfold_patch(after, unit, how, parts.next(0.5));
    return {unfold_patch(before, unit, plain, parts.next(1.0)), std::move(second)};
  }
  std::future<UnfoldReport> aside = run_async(unfold_before);
  try {
    UnfoldReport second = unfold_patch(after, unit, how, context);
    return {aside.valid() ? aside.get() : unfold_before(), std::move(second)};
  } catch (...) {
    abandoned = true;  // the other one need not go on; the destructor of `aside` waits for it
    throw;
  }
}

}  // namespace planish
