#pragma once

#include <array>
#include <string_view>
#include <utility>

#include <planish/core/fields.h>

namespace planish {

/// What a method that can move the border does with it.
enum class BorderRule {
  fixed,   ///< border vertices stay
  linked,  ///< those at exactly the same place move as one, so seams stay closed; others stay
};
inline constexpr std::array k_border_rules = {
    std::pair{BorderRule::fixed, std::string_view("fixed")},
    std::pair{BorderRule::linked, std::string_view("linked")}};
constexpr const auto& names_of(BorderRule) {
  return k_border_rules;
}

/// Global optimisation after Wang and Tang 2004: all inner vertices move at once, edges keep their
/// lengths as well as they can while a penalty on the summed squared defects grows.
/// docs/methods/global_penalty.md
struct GlobalPenalty {
  static constexpr std::string_view name = "global_penalty";
  static constexpr int usual_sweeps = 200;
  static constexpr bool honours_weights = false, honours_obstacle = false;
  int cg_steps = 5;
  double tolerance = 1e-4;
  BorderRule border = BorderRule::fixed;
};

template <class Visit>
void describe(GlobalPenalty& o, Visit&& visit) {
  visit("cg_steps", o.cg_steps, "conjugate-gradient steps between two settings of the penalty",
        Range{1.0, 1000.0});
  visit("tolerance", o.tolerance,
        "done when a sweep changes the summed squared defects by at most this share of what they "
        "were at first",
        Range{0.0, 1.0});
  visit("border", o.border,
        "whether border vertices that came at the same place, as on the two sides of a seam, stay "
        "or move together; all others stay");
}

}  // namespace planish
