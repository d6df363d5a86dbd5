#pragma once

#include <limits>
#include <string_view>

#include <planish/core/fields.h>
#include <planish/evolve/border_freedom.h>

namespace planish {

/// The method that finishes the job: from a coarse patch to the one given, each brought to where it
/// is flattenable by steps that weigh the pattern's strain against smoothness and closeness; then
/// polishing for the last defects. docs/methods/auto.md
struct Auto {
  static constexpr std::string_view name = "auto";
  static constexpr int usual_sweeps = 1000;
  static constexpr bool honours_weights = true, honours_obstacle = false;
  double max_strain = 0.0;
  double max_rms_strain = 0.0;
  double max_deviation = std::numeric_limits<double>::infinity();
  double min_angle = 0.0;
  double closeness = 1.0;
  BorderFreedom border = {};
};

template <class Visit>
void describe(Auto& o, Visit&& visit) {
  visit("max_strain", o.max_strain,
        "end near to where it began, but where a pattern need not stretch more, as a share of "
        "length; 0: go on until the patch is flattenable",
        Range{0.0, 1.0});
  visit("max_rms_strain", o.max_rms_strain,
        "the same by the root mean square of the strain, which a few places with more do not "
        "decide; 0: no limit",
        Range{0.0, 1.0});
  visit("max_deviation", o.max_deviation,
        "no vertex ends further than this from where it began, in model units", Range{0.0});
  visit("min_angle", o.min_angle,
        "no triangle gets an angle below this, or below the smallest one at first if that is "
        "smaller, in degrees",
        Range{0.0, 60.0});
  visit("closeness", o.closeness,
        "how much rougher the surface may get for staying close: 0: no rougher than at first, 1: "
        "twice as rough and 2.5 degrees more",
        Range{0.0, 1e6});
  visit("border", o.border,
        "what vertices of the border may do: stay, slide along the border as it was, or go as far "
        "from where they were as this, in model units");
}

}  // namespace planish
