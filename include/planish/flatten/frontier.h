#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <planish/flatten/compare.h>

namespace planish {

/// A run without a result.
struct FrontierFailure {
  Method method;    ///< that was run, with its options
  Failure failure;  ///< why there is no result
};

/// What strain costs: of one patch many results, from the patch as designed to flattenable.
struct FrontierReport {
  std::string name;                       ///< of the patch, for titles
  Unit unit = Unit::mm;                   ///< one unit of the model
  Candidate design;                       ///< the patch as designed
  std::vector<Candidate> curve;           ///< by flatten() with Auto, by growing rms deviation
  std::vector<Candidate> others;          ///< by other methods, in the order asked for
  std::vector<FrontierFailure> failures;  ///< runs without a result
  StrainLimits limits;                    ///< that were asked for
  std::vector<Caution> cautions;          ///< what the mesh of the patch cannot show

  /// The first point of the curve whose strain keeps the limits; nothing without any.
  std::optional<std::size_t> first_within_limit() const;
};

/// Which points a frontier has.
struct FrontierOptions {
  std::optional<int> points = {};  ///< on the curve, at least 2; default: the usual stops
  /// The curve has a point for them; texts and charts mark StrainLimits::both_ways().
  StrainLimits limits = {};
  std::vector<CompareRun> others = {};  ///< to compare with
  Unit unit = Unit::mm;                 ///< one unit of the model, for the report
  Constraints constraints = {};         ///< for every run
};

/// Where the curve stops: limits of rms strain, falling, then 0, which is flattenable. The usual
/// ones are those of k_candidate_strains that are below the strain of the patch's own pattern. With
/// a number of points they are evenly spaced on a logarithmic scale from there, which is not one of
/// them, to 0.1 %, or a tenth of it if that is less.
/// @param rms_strain of the patch's own pattern: where there is none there is only the 0
/// @param points 2 at least, the 0 among them
std::vector<double> frontier_limits(double rms_strain, std::optional<int> points = {});

/// Sets Candidate::dominated of all points.
void mark_dominated(FrontierReport& report);

/// Runs flatten() for the patch as designed, for every limit, as smooth as can be, and to flat, and
/// the other methods, each on the patch as designed. Of the usual stops every point is what
/// flatten() makes of its preset_options(). A run that fails does not end the others, and one whose
/// result is the design makes no point.
/// @throws Error option_out_of_range; what is not a disk, as unfold(); Cancelled
FrontierReport frontier(const Patch& patch, std::string name, const FrontierOptions& options = {},
                        const Context& context = {});

/// A line per point: method, limits of strain (empty where a run has none), strain, deviation, run.
std::string frontier_csv(const FrontierReport& report);

/// Strain over deviation as a stand-alone SVG. The strain axis is logarithmic and ends at 0.001 %:
/// what is less stands there.
std::string frontier_svg(const FrontierReport& report);

}  // namespace planish
