#pragma once

#include <string>

#include <planish/measure/deviation.h>
#include <planish/measure/fairness.h>
#include <planish/unfold/strain.h>

namespace planish {

/// A limit that the design's pattern misses, and what keeping it does to the form.
struct Way {
  /// Asked for, of one kind: `p99` of a material, else `rms`.
  StrainLimits limits = {};
  std::string material = {};  ///< name of that which limits.p99 is for; empty for a limit of rms
  /// True: of a coarser mesh of the design. False: of the result of this run.
  bool estimated = true;
  bool reached = false;      ///< its pattern keeps the limit and does not overlap itself
  EdgeStrain strain = {};    ///< of its pattern
  Deviation deviation = {};  ///< from the design, model units
  Fairness fairness = {};    ///< beside the design

  /// How sharp the sharpest new fold is, degrees; 0 where nothing is bent more sharply.
  double sharpest_fold() const {
    return fairness.sharpest_fold ? fairness.sharpest_fold->degrees : 0.0;
  }
  /// Whether the form is smooth and kept.
  bool keeps_form() const { return fairness.is_smooth() && fairness.keeps_form(); }
};

}  // namespace planish
