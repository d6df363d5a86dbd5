#pragma once

#include <array>
#include <limits>
#include <string_view>
#include <utility>

#include <planish/core/fields.h>
#include <planish/evolve/border_freedom.h>

namespace planish {

/// Strain, rms, as a share of length, that nobody can measure on cloth, leather or plate: where
/// `auto` ends if the surface is to stay smooth and no other limit is given.
inline constexpr double k_unmeasurable_strain = 1e-3;

/// What `auto` gives way in last.
enum class Prefer {
  smooth,  ///< no crumples: strain is left where only they would take it out
  flat,    ///< flattenable, as smooth as that allows
  near,    ///< flattenable, or at a limit of strain, and near to the design, though it crumples
};
inline constexpr std::array k_preferences = {std::pair{Prefer::smooth, std::string_view("smooth")},
                                             std::pair{Prefer::flat, std::string_view("flat")},
                                             std::pair{Prefer::near, std::string_view("near")}};
constexpr const auto& names_of(Prefer) {
  return k_preferences;
}

/// The method that finishes the job, from a coarse patch to the one given. Smooth or flat: bending,
/// strain and distance are weighed against one another, and strain is taken out slowly
/// (docs/methods/smooth.md). Near: each level is brought to where it is flattenable by steps that
/// weigh strain against roughness and closeness (docs/methods/auto.md). Flat and near end with
/// polishing for the last defects.
struct Auto {
  static constexpr std::string_view name = "auto";
  static constexpr int usual_sweeps = 1000;
  static constexpr bool honours_weights = true, honours_obstacle = false;
  double max_strain = 0.0;
  double max_rms_strain = 0.0;
  double max_deviation = std::numeric_limits<double>::infinity();
  double min_angle = 0.0;
  double closeness = 1.0;
  Prefer prefer = Prefer::smooth;
  BorderFreedom border = {};
};

template <class Visit>
void describe(Auto& o, Visit&& visit) {
  visit("max_strain", o.max_strain,
        "end near to where it began, but where a pattern need not stretch more, as a share of "
        "length; 0: go on until the patch is flattenable",
        Range{0.0, 1.0});
  visit("max_rms_strain", o.max_rms_strain,
        "the same by the root mean square of the strain, which a few positions with more do not "
        "decide; 0: no limit",
        Range{0.0, 1.0});
  visit("max_deviation", o.max_deviation,
        "no vertex ends further than this from where it began, in model units", Range{0.0});
  visit("min_angle", o.min_angle,
        "no triangle gets an angle below this, or below the smallest one at first if that is "
        "smaller, in degrees",
        Range{0.0, 60.0});
  visit("prefer", o.prefer,
        "what counts most: that the surface stays smooth, becomes flattenable, or stays near");
  visit("closeness", o.closeness,
        "how much rougher the surface may get for staying close: 0: no rougher than at first, 1: "
        "twice as rough and 2.5 degrees more",
        Range{0.0, 1e6});
  visit("border", o.border,
        "what vertices of the border may do: stay, slide along the border as it was, or go as far "
        "from where they were as this, in model units");
}

}  // namespace planish
