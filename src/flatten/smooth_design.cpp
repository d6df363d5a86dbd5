#include <utility>

#include <planish/flatten/flatten.h>

#include "measure/smoothed.h"

namespace planish {

SmoothedDesign smooth_design(const TriMesh& raw, double length) {
  const Connectivity connectivity(raw);
  SmoothedDesign design;
  design.mesh = {smoothed_positions(raw, connectivity, length), raw.triangles};
  design.done = {length, measure_deviation(raw, design.mesh.positions, connectivity)};
  return design;
}

EvolveReport with_smoothing(EvolveReport report, const TriMesh& raw, const SmoothedFirst& done) {
  report.smoothed_first = done;
  report.deviation = measure_deviation(raw, report.result.positions, Connectivity(raw));
  return report;
}

}  // namespace planish
