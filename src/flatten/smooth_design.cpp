#include <utility>

#include <planish/flatten/flatten.h>

#include "measure/smoothed.h"

namespace planish {

SmoothedDesign smooth_design(const Patch& raw, double length) {
  const Patch smooth = raw.with_positions(smoothed_positions(raw, length));
  return {smooth, {length, measure_deviation(raw, smooth.positions())}};
}

EvolveReport with_smoothing(EvolveReport report, const Patch& raw, const SmoothedFirst& done) {
  report.smoothed_first = done;
  report.deviation = measure_deviation(raw, report.result.positions);
  return report;
}

}  // namespace planish
