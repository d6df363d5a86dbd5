#include <algorithm>
#include <utility>
#include <vector>

#include <planish/flatten/flatten.h>

#include "flatten/steps/least_change.h"
#include "measure/smoothed.h"
#include "measure/smoothed_border.h"

namespace planish {

SmoothedDesign smooth_design(const Patch& raw, double length) {
  const Patch smooth = raw.with_positions(smoothed_positions(raw, length));
  return {smooth, {length, measure_deviation(raw, smooth.positions())}};
}

SmoothedDesign smooth_within(const Patch& raw, double wave, double reach, double border_reach) {
  const Patch fair = border_reach > 0.0 ? raw.with_positions(with_smoothed_border(raw, wave)) : raw;
  std::vector<Vec3> positions = smoothed_positions(fair, wave);
  for (Index v = 0; v < positions.size(); ++v) {
    const Vec3 origin = raw.positions()[v], move = positions[v] - origin;
    const double most = raw.is_border(v) ? std::min(border_reach, reach) : reach;
    const double length = norm(move);
    if (length > most) positions[v] = origin + (most / length) * move;
  }
  const Deviation moved = measure_deviation(raw, positions);
  return {raw.with_positions(std::move(positions)), {wave, moved}};
}

EvolveReport with_smoothing(EvolveReport report, const Patch& raw, const SmoothingSummary& done) {
  report.smoothed_first = done;
  report.deviation = measure_deviation(raw, report.result.positions);
  return report;
}

}  // namespace planish
