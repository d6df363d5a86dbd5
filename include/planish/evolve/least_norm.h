#pragma once

#include <array>
#include <string_view>
#include <utility>

#include <planish/core/fields.h>

namespace planish {

/// How a least-norm step is turned into the next positions.
enum class LeastNormUpdate {
  direct,     ///< the step itself
  uniform,    ///< the least-squares update: stepped, then faired with the umbrella vector
  cotangent,  ///< the same, faired with the cotangent Laplacian
};
inline constexpr std::array k_least_norm_updates = {
    std::pair{LeastNormUpdate::direct, std::string_view("direct")},
    std::pair{LeastNormUpdate::uniform, std::string_view("uniform")},
    std::pair{LeastNormUpdate::cotangent, std::string_view("cotangent")}};
constexpr const auto& names_of(LeastNormUpdate) {
  return k_least_norm_updates;
}

/// Least norm (Wang 2008, SMI): the shortest move of all inner vertices together that closes every
/// angle sum to first order, again and again; at first faired, then direct.
/// docs/methods/least_norm.md
struct LeastNorm {
  static constexpr std::string_view name = "least_norm";
  static constexpr int usual_sweeps = 200;
  static constexpr bool honours_weights = true, honours_obstacle = false;
  LeastNormUpdate update = LeastNormUpdate::cotangent;
  double switch_e_max = 1e-3;
  int switch_after = 20;
  double switch_fall = 0.01;
  double damping = 0.0;
  double border_weight = 1.0;
  double max_step = 0.5;
  double min_step = 1e-6;
};

template <class Visit>
void describe(LeastNorm& o, Visit&& visit) {
  visit("update", o.update, "how a step becomes positions until direct steps take over");
  visit("switch_e_max", o.switch_e_max,
        "direct steps take over when e_max is below this, in radians", Range{0.0});
  visit("switch_after", o.switch_after, "and after so many faired steps, when one gains too little",
        Range{0.0, 1e9});
  visit("switch_fall", o.switch_fall, "too little: e_max falls by less than this, in radians",
        Range{0.0});
  visit(
      "damping", o.damping,
      "of faired steps, in units of the matrix's median diagonal; 0: 3e-6 for cotangent, 3e-4 for "
      "uniform",
      Range{0.0, 1e3});
  visit("border_weight", o.border_weight,
        "how dear moving vertices next to the border is; 10 keeps the patch's slant there",
        Range{1e-3, 1e3});
  visit("max_step", o.max_step, "a direct step moves no vertex by more of its shortest edge",
        Range{1e-6, 10.0});
  visit("min_step", o.min_step,
        "converged when the rms step is below this share of the mean edge length", Range{0.0, 1.0});
}

}  // namespace planish
