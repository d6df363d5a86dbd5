#pragma once

#include <array>
#include <optional>
#include <string>

#include <planish/report/flatten.h>

namespace planish {

/// Whether a pattern keeps the limit of strain that its method was given: measured at the pattern,
/// where the method goes by an estimate.
struct StrainCheck {
  double max_strain = 0.0;      ///< the limit, a share of length
  double largest_strain = 0.0;  ///< |strain| of the pattern's edge that has most
  std::array<Index, 2> edge{};  ///< the vertices of that edge
  Vec3 at;                      ///< its middle on the processed patch, model units

  bool met() const { return largest_strain <= max_strain; }
};

/// The same of a limit of the strain's root mean square.
struct RmsStrainCheck {
  double max_rms_strain = 0.0;  ///< the limit, a share of length
  double rms_strain = 0.0;      ///< of the pattern's edges

  bool met() const { return rms_strain <= max_rms_strain; }
};

/// Nothing where the method has no limit of that kind, or was given none.
std::optional<StrainCheck> check_strain(const FlattenReport& report);
std::optional<RmsStrainCheck> check_rms_strain(const FlattenReport& report);

/// That in a sentence: ASCII.
std::string check_text(const StrainCheck& check);
std::string check_text(const RmsStrainCheck& check);

/// The sentences of all limits of strain that were given; empty where there are none.
std::string strain_limits_text(const FlattenReport& report);

}  // namespace planish
