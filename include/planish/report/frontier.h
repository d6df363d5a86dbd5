#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <planish/report/compare.h>

namespace planish {

/// What one run made of a patch: how strained its pattern is, and how far its vertices went for it.
struct FrontierPoint {
  Method method;
  StopReason stop = StopReason::sweep_limit;
  std::size_t sweeps = 0;
  double seconds = 0.0;  ///< of evolving
  EdgeStrain strain;     ///< of the pattern of the result
  Deviation deviation;   ///< of the result from the patch
  bool flattenable = false;
  Fairness fairness = {};  ///< of the result beside the patch
};

/// A run without a result.
struct FrontierFailure {
  Method method;
  CompareFailure failure;
};

/// What strain costs: of one patch many results, from the patch as it came to flattenable.
struct FrontierReport {
  std::string name;  ///< of the patch, for titles
  Unit unit = Unit::mm;
  EdgeStrain before;                 ///< of the pattern of the patch as it came
  std::vector<FrontierPoint> curve;  ///< by Auto, by growing rms deviation
  std::vector<FrontierPoint> others;
  std::vector<FrontierFailure> failures;
  std::optional<double> limit;  ///< that was asked for

  /// The first point of the curve whose largest strain keeps the limit; nothing without one.
  std::optional<std::size_t> first_within_limit() const;
};

struct FrontierOptions {
  int points = 8;                       ///< of the curve; 2 at least
  std::optional<double> limit = {};     ///< of strain, above 0: the curve has a point for it too
  std::vector<CompareRun> others = {};  ///< to compare with
  Unit unit = Unit::mm;
  unsigned threads = 0;
  Constraints constraints = {};
};

/// The limits of strain of the curve's points: from the strain of the patch's own pattern down to
/// 0.1 %, or a tenth of it if that is less, each the same share of the one before; then 0, which is
/// flattenable. Where the pattern has no strain there is only the 0.
/// @param largest_strain of the patch's own pattern
/// @param points 2 at least
std::vector<double> frontier_limits(double largest_strain, int points);

/// Runs Auto once for every limit, and the other methods, each on the patch as it came, and lays
/// every result flat. A run that fails does not end the others. Nothing when cancelled.
/// @throws Error option_out_of_range; what is not a disk, as unfold()
std::optional<FrontierReport> frontier(TriMesh mesh, std::string name,
                                       const FrontierOptions& options = {},
                                       const OnCompareProgress& on_progress = {});

/// A line per point: method, limit of strain (empty but for Auto), strain, deviation, run.
std::string frontier_csv(const FrontierReport& report);

/// Strain over deviation as a stand-alone SVG. The strain axis is logarithmic and ends at 0.001 %:
/// what is less stands there.
std::string frontier_svg(const FrontierReport& report);

}  // namespace planish
