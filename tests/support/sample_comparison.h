#pragma once

// A comparison without evolving or unfolding: two runs with figures that are all different, and one
// that failed.

#include <planish/flatten/compare.h>

#include "support/sample_report.h"

namespace planish::samples {

inline CompareReport comparison() {
  const FlattenReport one = flatten_report();
  CompareReport report;
  report.name = "front panel";
  report.input = one.input;
  report.before = one.evolve.before;
  report.design_least_stretch = one.design_least_stretch;

  ComparedMethod better{{ControllableLaplacian{}, {}}, one.evolve, one.unfold, {}};
  better.evolve->method = ControllableLaplacian{};
  better.unfold->strain = {0.1187, 0.0261, 0.0643};

  ComparedMethod worse{{ClassicalLaplacian{.lambda = 0.25}, {}}, one.evolve, one.unfold, {}};
  worse.evolve->method = worse.run.method;
  worse.evolve->after.figures.energy = 0.0123;
  worse.evolve->after.figures.min_angle = 0.0021;
  worse.evolve->result.stop = StopReason::stalled;
  worse.evolve->result.history.resize(4);
  worse.evolve->result.seconds = 3.25;
  worse.evolve->deviation = {0.4321, 0.8765, 0.0123};
  worse.unfold->strain = {0.4187, 0.0861, 0.3143};

  ComparedMethod failed{{ClassicalLaplacian{}, {}}, {}, {}, {}};
  failed.failure = {"unsupported_constraint", "no <weights> here"};

  report.runs = {better, worse, failed};
  return report;
}

}  // namespace planish::samples
