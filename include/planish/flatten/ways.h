#pragma once

#include <string>

#include <planish/measure/deviation.h>
#include <planish/measure/fairness.h>
#include <planish/unfold/strain.h>

namespace planish {

/// A limit that the design's pattern misses, and what keeping it does to the form.
struct Way {
  StrainLimits limits = {};   ///< those of a material, or one that was asked for
  std::string material = {};  ///< its name; empty for other limits
  /// True: of a coarser mesh of the design. False: of the result of this run.
  bool estimated = true;
  bool reached = false;      ///< its pattern keeps the limit and does not overlap itself
  EdgeStrain strain = {};    ///< of its pattern
  Deviation deviation = {};  ///< from the design, model units
  Fairness fairness = {};    ///< beside the design

  /// The limit as one number, a share of length: of the rms, or of the |strain| that asks for as
  /// much as all limits of edges.
  double limit() const { return limits.rms > 0.0 ? limits.rms : limits.both_ways(); }
  /// Whether that figure says all: the limits are alike for stretch and compression.
  bool has_one_limit() const { return limits.rms > 0.0 || limits.p99 > 0.0 || limits.max > 0.0; }
  /// How sharp the sharpest new fold is, degrees; 0 where nothing is bent more sharply.
  double sharpest_fold() const {
    return fairness.sharpest_fold ? fairness.sharpest_fold->degrees : 0.0;
  }
  /// Whether the form is smooth and kept.
  bool keeps_form() const { return fairness.is_smooth() && fairness.keeps_form(); }
};

}  // namespace planish
