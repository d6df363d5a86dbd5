#pragma once

#include <span>
#include <string>

#include <planish/unfold/strain.h>

namespace planish {

/// Whether a pattern keeps a limit of strain, in a sentence, ASCII: "The limit of 10 % on 99 % of
/// the area is kept: the pattern has 6.8 %."
std::string strain_limit_text(const StrainLimitCheck& check);

/// The sentences of all checks; empty where there are none.
std::string strain_limits_text(std::span<const StrainLimitCheck> checks);

}  // namespace planish
