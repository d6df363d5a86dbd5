#include "flatten/check_request.h"

#include <planish/core/range.h>

#include "evolve/check_stopping.h"

namespace planish {

void check_request(const FlattenOptions& options) {
  require(options.limits);
  check_options(options.method.value_or(options.as_needed));
  if (options.stopping) check_stopping(*options.stopping);
  if (options.fold && !options.constraints.obstacle.triangles.empty()) {
    throw Error(ErrorCode::unsupported_constraint,
                "fold does not go together with an obstacle, which has no mirror image: give the "
                "whole piece instead of its half");
  }
  check_range("smooth_first", options.smooth_first, Range{0.0});
}

}  // namespace planish
