#include <utility>

#include <planish/core/error.h>
#include <planish/flatten/compare.h>

#include "core/job.h"

namespace planish {

namespace {

/// Patterns are compared by one measure.
const UnfoldOptions k_least_stretch = {.least_stretch = true};

template <std::size_t... I>
std::vector<CompareRun> runs_of_all(std::index_sequence<I...>) {
  std::vector<CompareRun> runs;
  (runs.push_back({std::variant_alternative_t<I, Method>{},
                   usual_stopping(std::variant_alternative_t<I, Method>{})}),
   ...);
  return runs;
}

/// The failure that is being handled. What a method of one's own throws is no fault of the library.
Failure failure_of(const Method& method) {
  Failure failure = current_failure();
  if (failure.code == "internal_error" && std::holds_alternative<OwnMethod>(method))
    failure.code = to_string(ErrorCode::method_failed);
  return failure;
}

/// Does the work of compare(), one part after the other.
class Comparison {
 public:
  Comparison(CompareReport& report, const CompareOptions& options, const Context& context,
             std::size_t parts)
      : report_(report), options_(options), context_(context), parts_(parts) {}

  void measure_input() {
    report_progress(context_, {"measuring", 0.0});
    report_.before = measure_patch(report_.input);
    require(report_.before.inspection, Purpose::evolve);
    const auto problem = blocking_problem(report_.before.inspection, Purpose::unfold);
    const Context part = next_part("");
    if (problem) {
      report_.why_no_patterns = problem->message;
      return;
    }
    try {
      report_.design_least_stretch =
          unfold_patch(report_.input, options_.unit, k_least_stretch, part);
    } catch (...) {
      report_.why_no_patterns = current_failure().message;
    }
  }

  void add(const CompareRun& run) {
    const std::string_view name = name_of(run.method);
    const Context evolving = next_part(name), unfolding = next_part(name);
    ComparedMethod& compared = report_.runs.emplace_back();
    compared.run = run;
    try {
      compared.evolve =
          evolve_patch(report_.input, run.method, run.stopping, options_.constraints, evolving);
      if (!report_.design_least_stretch) return;
      const std::vector<Vec3>& evolved = compared.evolve->result.positions;
      compared.unfold = unfold_patch(report_.input.with_positions(evolved), options_.unit,
                                     k_least_stretch, unfolding);
    } catch (...) {
      compared.failure = failure_of(run.method);
    }
  }

 private:
  Context next_part(std::string_view method) {
    const auto parts = static_cast<double>(parts_);
    const double begin = static_cast<double>(done_++) / parts;
    return part_of(context_, begin, static_cast<double>(done_) / parts, method);
  }

  CompareReport& report_;
  const CompareOptions& options_;
  const Context& context_;
  std::size_t parts_, done_ = 0;
};

}  // namespace

std::vector<CompareRun> runs_of_all_methods() {
  return runs_of_all(std::make_index_sequence<k_named_methods>());
}

CompareReport compare(const Patch& patch, std::string name, const std::vector<CompareRun>& runs,
                      const CompareOptions& options, const Context& context) {
  CompareReport report;
  report.name = std::move(name);
  report.input = patch;
  report.unit = options.unit;
  report.cautions = find_cautions(patch);
  Comparison comparison(report, options, context, 1 + 2 * runs.size());
  comparison.measure_input();
  for (const CompareRun& run : runs)
    comparison.add(run);
  return report;
}

}  // namespace planish
