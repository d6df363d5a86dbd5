#pragma once

#include <string_view>

#include <planish/core/fields.h>

namespace planish {

/// Flattenable Laplacian mesh (Wang 2008, Computer-Aided Design): the fairest surface near the
/// patch as it came whose angle sums are all closed, by Newton's method for the Lagrangian without
/// the second derivatives of the angles. docs/methods/flattenable_laplacian.md
struct FlattenableLaplacian {
  static constexpr std::string_view name = "flattenable_laplacian";
  static constexpr int usual_sweeps = 100;
  static constexpr bool honours_weights = true, honours_obstacle = false;
  double fairness = 1.0;
  double position = 0.1;
  double tau = 0.25;
  double damping = 1e-2;
  int rebase_every = 0;
  double min_step = 1e-5;
};

template <class Visit>
void describe(FlattenableLaplacian& o, Visit&& visit) {
  visit("fairness", o.fairness, "w1: how much edges are to be short and even", Range{0.0, 1e6});
  visit("position", o.position, "w2: how much vertices are to stay where they began",
        Range{1e-9, 1e6});
  visit("tau", o.tau, "share of each step that is taken", Range{1e-3, 1.0});
  visit("damping", o.damping,
        "how soft the constraints are, in units of the matrix; as small as 1e-9 they are hard, as "
        "printed, which few dense patches bear",
        Range{1e-12, 1e3});
  visit("rebase_every", o.rebase_every,
        "after so many steps the positions reached become those to stay at; 0: never",
        Range{0.0, 1e9});
  visit("min_step", o.min_step,
        "converged when the rms step is below this share of the mean edge length", Range{0.0, 1.0});
}

}  // namespace planish
