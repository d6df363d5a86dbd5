#pragma once

#include <string_view>

#include <planish/core/fields.h>

namespace planish {

/// Local offsets after Wang and Tang 2004: always the inner vertex with the largest defect moves,
/// along the normal that it had at first and no further than a band, so that its ring energy
/// falls. Energy never rises. docs/methods/local_offset.md
struct LocalOffset {
  static constexpr std::string_view name = "local_offset";
  static constexpr int usual_sweeps = 200;
  static constexpr bool honours_weights = false, honours_obstacle = false;
  double band = 0.0;
  double enough = 1e-2;
  int max_updates = 500'000;
};

template <class Visit>
void describe(LocalOffset& o, Visit&& visit) {
  visit("band", o.band,
        "no vertex ends further than this from where it began, in model units; 0 for the mean "
        "length of the edges at inner vertices",
        Range{0.0});
  visit("enough", o.enough, "a defect of at most this is left alone, in radians", Range{0.0});
  visit("max_updates", o.max_updates, "at most so many vertices are tried, in all sweeps together",
        Range{0.0, 1e9});
}

}  // namespace planish
