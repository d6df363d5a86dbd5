#pragma once

#include <string>

#include <planish/core/unit.h>
#include <planish/mesh/patch.h>
#include <planish/pattern/nest.h>
#include <planish/pattern/pattern_options.h>

#include "output/pattern_output.h"
#include "shell/session.h"

namespace planish::cli {

/// How a pattern is to be written, as far as its size matters.
struct PatternPlan {
  Unit unit = Unit::mm;                 ///< one unit of the model
  PatternOutput output;                 ///< with or without pages
  PatternOptions annotations = {};      ///< quantity and allowance
  const NestOptions* sheets = nullptr;  ///< that it is laid on, if any
};

/// Refuses, before a patch is evolved, what writing its pattern would refuse by its size: too many
/// pages, too many copies, and a piece for which no sheet has a place even if it loses a fifth of
/// its size. What is nearer to a limit is known only when the pattern is there.
/// @throws Error too_large, piece_too_large; Cancelled
void check_pattern_size(const Patch& patch, const std::string& name, const PatternPlan& plan,
                        const Session& session);

/// The same of the copies of several patches.
/// @throws Error too_large
void check_copies_of(std::size_t patches, const PatternPlan& plan);

}  // namespace planish::cli
