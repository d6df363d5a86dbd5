#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <planish/flatten/flatten.h>

namespace planish {

/// A method and when it ends.
struct CompareRun {
  Method method;      ///< with its options
  Stopping stopping;  ///< sweeps and e_max at which it ends
};

/// Every method with its default options and usual_stopping().
std::vector<CompareRun> runs_of_all_methods();

/// How compare() runs every method.
struct CompareOptions {
  Unit unit = Unit::mm;          ///< one unit of the model, for the patterns
  Constraints constraints = {};  ///< for every method
};

/// What one method made of the patch.
struct ComparedMethod {
  CompareRun run;                      ///< what was asked for
  std::optional<EvolveReport> evolve;  ///< none where evolving failed
  std::optional<UnfoldReport> unfold;  ///< of the result; none where there is no pattern
  std::optional<Failure> failure;      ///< of evolving or unfolding
};

/// Several methods, each tried on the same patch.
struct CompareReport {
  std::string name;                                  ///< of the patch, for titles
  Patch input;                                       ///< on which every method began
  MeasuredPatch before;                              ///< figures of the input
  std::optional<UnfoldReport> design_least_stretch;  ///< of the input itself
  std::string why_no_patterns;                       ///< where the input cannot be laid flat
  std::vector<ComparedMethod> runs;                  ///< in the order asked for
  Unit unit = Unit::mm;                              ///< one unit of the model
  std::vector<Caution> cautions;                     ///< what the mesh of the input cannot show
};

/// Runs one method after the other, so that none takes time from another, each on the patch as it
/// came. Where the input can be laid flat, so is every result; where not, as it is no disk, methods
/// are compared without patterns. A method that fails does not end the others.
/// @throws Error what stands in the way of Purpose::evolve; Cancelled
CompareReport compare(const Patch& patch, std::string name, const std::vector<CompareRun>& runs,
                      const CompareOptions& options = {}, const Context& context = {});

/// What a method did for the pattern and at what price, in a few plain words of ASCII, as in
/// "better pattern: strain 7.6 % -> 1.2 %; needles: smallest angle 0.01 deg". Without patterns it
/// goes by sum_abs_defect, which unlike the energy does not depend on the density of the mesh.
std::string verdict_text(const CompareReport& report, const ComparedMethod& method);

/// Which run to trust, an index of `runs`: least rms strain (without patterns: least
/// sum_abs_defect) of those that improved on the input by more than 2 % without needles, crumpling,
/// flipped triangles or an overlap of their own making. None where no run did.
std::optional<std::size_t> best_run(const CompareReport& report);

}  // namespace planish
