#pragma once

#include <limits>
#include <string_view>

#include <planish/core/fields.h>

namespace planish {

/// Local flattenable perturbation (Wang, Towards flattenable mesh surfaces, 2008): around the worst
/// vertex, again and again, the least change that makes all angle sums of a few rings 2 pi to first
/// order. For patches that are nearly flattenable; keeps out of an obstacle.
/// docs/methods/local_perturbation.md
struct LocalPerturbation {
  static constexpr std::string_view name = "local_perturbation";
  static constexpr int usual_sweeps = 50;
  static constexpr bool honours_weights = true, honours_obstacle = true;
  int rings = 3;
  int inner_steps = 5;
  double tau = 0.1;
  double enough = 1e-3;
  double clearance = 0.0;
  double max_deviation = std::numeric_limits<double>::infinity();
};

template <class Visit>
void describe(LocalPerturbation& o, Visit&& visit) {
  visit("rings", o.rings, "so many rings around a vertex move at once", Range{1.0, 10.0});
  visit("inner_steps", o.inner_steps, "steps each time that a vertex is taken", Range{1.0, 1000.0});
  visit("tau", o.tau, "share of the solved step that is gone", Range{0.0, 1.0});
  visit("enough", o.enough, "e_max at which the method is done, in radians", Range{0.0});
  visit("clearance", o.clearance, "distance to keep from the obstacle, in model units", Range{0.0});
  visit("max_deviation", o.max_deviation,
        "no vertex ends further than this from where it began, in model units", Range{0.0});
}

}  // namespace planish
