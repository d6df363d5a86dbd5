#pragma once

#include <string>
#include <vector>

#include <planish/flatten/flatten.h>

namespace planish {

/// What a limit is of.
enum class LimitOf { strain, p99_strain, rms_strain, deviation, angle, defect };

/// A limit that was given, and whether the result keeps it.
struct LimitCheck {
  LimitOf what = LimitOf::strain;
  double limit = 0.0;  ///< a share of length, model units, degrees, radians
  double value = 0.0;  ///< what came out: the largest, of angles the smallest
  bool met = false;
};

/// All limits that were given to the run: what is as the method has it unasked is none. An angle
/// limit is met also where no angle got smaller than the smallest one before.
std::vector<LimitCheck> limit_checks(const FlattenReport& report);

/// The limit in words: "at most 2 %".
std::string limit_text(const LimitCheck& check, Unit unit);

}  // namespace planish
