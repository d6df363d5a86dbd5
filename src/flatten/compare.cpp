#include <utility>

#include <planish/flatten/compare.h>

#include "flatten/evolve_progress.h"

namespace planish {

namespace {

template <std::size_t... I>
std::vector<CompareRun> runs_of_all(std::index_sequence<I...>) {
  std::vector<CompareRun> runs;
  (runs.push_back({std::variant_alternative_t<I, Method>{},
                   usual_stopping(std::variant_alternative_t<I, Method>{})}),
   ...);
  return runs;
}

/// Does the work of compare(), one part after the other.
class Comparison {
 public:
  Comparison(CompareReport& report, const CompareOptions& options,
             const OnCompareProgress& on_progress, std::size_t parts)
      : report_(report), options_(options), on_progress_(on_progress), parts_(parts) {}

  bool cancelled() const { return cancelled_; }

  void measure_input() {
    if (!tell(FlattenStage::measuring, "", 0.0)) return;
    report_.before = measure_patch(report_.input);
    require(report_.before.inspection, Purpose::evolve);
    const auto problem = blocking_problem(report_.before.inspection, Purpose::unfold);
    if (problem) {
      report_.why_no_patterns = problem->message;
    } else {
      try {
        report_.unfold_before = unfolded(report_.input, "");
      } catch (...) {
        report_.why_no_patterns = current_failure().message;
      }
    }
    ++done_;
  }

  void add(const CompareRun& run) {
    const std::string_view name = name_of(run.method);
    if (!tell(FlattenStage::evolving, name, 0.0)) return;
    ComparedMethod& compared = report_.runs.emplace_back();
    compared.run = run;
    try {
      compared.evolve = evolved(run, name);
      ++done_;
      if (report_.unfold_before && !cancelled_) {
        compared.unfold =
            unfolded(report_.input.with_positions(compared.evolve->result.positions), name);
      }
    } catch (...) {
      compared.failure = current_failure();
      if (!compared.evolve) ++done_;
    }
    ++done_;
  }

 private:
  bool tell(FlattenStage stage, std::string_view method, double share) {
    const double whole = (static_cast<double>(done_) + share) / static_cast<double>(parts_);
    if (on_progress_ && !on_progress_(stage, method, whole)) cancelled_ = true;
    return !cancelled_;
  }

  EvolveReport evolved(const CompareRun& run, std::string_view name) {
    EvolveProgress progress(run.stopping, report_.input.vertex_count());
    return evolve_patch(
        report_.input, run.method, run.stopping,
        [&](const SweepRecord& record) {
          return tell(FlattenStage::evolving, name, progress.after(record));
        },
        options_.threads, options_.constraints);
  }

  std::optional<UnfoldReport> unfolded(const Patch& patch, std::string_view name) {
    double left = 1.0;  // how many steps it will take is not known
    return unfold_patch(patch, options_.unit,
                        [&](int /*step*/, double /*energy*/) {
                          left *= 0.9;
                          return tell(FlattenStage::unfolding, name, 1.0 - left);
                        },
                        {.threads = options_.threads});
  }

  CompareReport& report_;
  const CompareOptions& options_;
  const OnCompareProgress& on_progress_;
  std::size_t parts_, done_ = 0;
  bool cancelled_ = false;
};

}  // namespace

std::vector<CompareRun> runs_of_all_methods() {
  return runs_of_all(std::make_index_sequence<std::variant_size_v<Method>>());
}

std::optional<CompareReport> compare(const Patch& patch, std::string name,
                                     const std::vector<CompareRun>& runs,
                                     const CompareOptions& options,
                                     const OnCompareProgress& on_progress) {
  CompareReport report;
  report.name = std::move(name);
  report.input = patch;
  Comparison comparison(report, options, on_progress, 1 + 2 * runs.size());
  comparison.measure_input();
  for (const CompareRun& run : runs) {
    if (comparison.cancelled()) break;
    comparison.add(run);
  }
  if (comparison.cancelled()) return std::nullopt;
  return report;
}

}  // namespace planish
