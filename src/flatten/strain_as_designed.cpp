#include <planish/flatten/flatten.h>

#include "core/job.h"

namespace planish {

StrainAsDesigned strain_as_designed(const Patch& patch, const StrainLimits& limits,
                                    const Context& context) {
  PartsOfJob parts(context);
  const Pattern least = unfold(patch, {}, parts.next(0.2));
  StrainAsDesigned strain = {edge_strain(patch, least.positions)};
  if (limits.any()) {
    const Pattern limited = unfold(patch, {.limits = limits}, parts.next(0.5));
    strain.limits = check_limits(patch, limited.positions, limits);
  }
  if (patch.vertex_count() > StrainAsDesigned::k_most_searched) return strain;
  strain.smallest_limit = smallest_limit(patch, least, parts.next(1.0));
  return strain;
}

}  // namespace planish
