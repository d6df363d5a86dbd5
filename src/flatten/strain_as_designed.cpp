#include <planish/flatten/flatten.h>

#include "core/job.h"

namespace planish {

StrainAsDesigned strain_as_designed(const Patch& patch, const StrainLimits& limits,
                                    const Context& context) {
  PartsOfJob parts(context);
  StrainAsDesigned strain;
  strain.pattern = unfold(patch, {.least_stretch = true}, parts.next(0.2));
  strain.least_stretch = edge_strain(patch, strain.pattern.positions);
  if (limits.any()) {
    const Pattern limited =
        unfold(patch, {.least_stretch = true, .limits = limits}, parts.next(0.5));
    strain.limits = check_limits(patch, limited.positions, limits);
  }
  if (patch.vertex_count() > StrainAsDesigned::k_most_searched) return strain;
  strain.smallest_limit = smallest_limit(patch, strain.pattern, parts.next(1.0));
  return strain;
}

}  // namespace planish
