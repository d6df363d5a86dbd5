#pragma once

#include <vector>

#include <planish/measure/material.h>
#include <planish/unfold/strain.h>

namespace planish {

/// The limits of strain that a material has: those of |strain| where it gives as far in both ways,
/// else those of stretch and of compression.
StrainLimits limits_of(const Material& material);

/// Whether a material takes the strain of a pattern, and what speaks most against it: the limit of
/// which most is used up, of all that it has.
struct MaterialVerdict {
  const Material* material = nullptr;               ///< of materials()
  bool takes = false;                               ///< whether all of its limits are kept
  StrainLimitKind tightest = StrainLimitKind::p99;  ///< the kind of that limit
  double limit = 0.0;                               ///< what it is, a share of length
  double strain = 0.0;                              ///< what the pattern has, a share of length
};

/// One for each of materials(), in their order.
std::vector<MaterialVerdict> materials_for(const EdgeStrain& strain);

}  // namespace planish
