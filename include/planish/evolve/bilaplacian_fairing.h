#pragma once

#include <string_view>

#include <planish/core/fields.h>

namespace planish {

/// Bi-Laplacian fairing: all inner vertices at once to where the surface bends least, the border
/// and the slant at it kept; again with the Laplacian of the surface found. Defects are not looked
/// at: smooth surfaces have small ones. docs/methods/fairing.md
struct BilaplacianFairing {
  static constexpr std::string_view name = "fairing";
  static constexpr int usual_sweeps = 1;
  static constexpr bool honours_weights = true, honours_obstacle = false;
  double pull = 100.0;
  double min_step = 1e-4;
};

template <class Visit>
void describe(BilaplacianFairing& o, Visit&& visit) {
  visit("pull", o.pull,
        "how strongly vertices are drawn to where they began; waves longer than 2 pi sizes over "
        "the root of this stay, a size being the root of the area; 0: not at all",
        Range{0.0, 1e9});
  visit("min_step", o.min_step,
        "converged when the rms step is below this share of the mean edge length", Range{0.0, 1.0});
}

}  // namespace planish
