#pragma once

#include <string_view>

namespace planish {

/// Why an evolution ended.
enum class StopReason {
  reached_target,   ///< e_max is at most the target
  stalled,          ///< a sweep moved nothing, so no later one would
  converged,        ///< the method's own test says that it is done
  strain_met,       ///< the pattern's strain is within the limit that was asked for
  deviation_limit,  ///< more would take vertices further away than is allowed
  angle_limit,      ///< more would make angles smaller than is allowed
  smooth_limit,     ///< more would crumple the surface
  sweep_limit,
  cancelled,
};
std::string_view to_string(StopReason reason);

/// In words: why it ended.
std::string_view stop_text(StopReason reason);

}  // namespace planish
