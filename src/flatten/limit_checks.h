#pragma once

#include <string>
#include <vector>

#include <planish/flatten/flatten.h>

namespace planish {

/// All limits that were given to the run: what is as the method has it unasked is none. An angle
/// limit is met also where no angle got smaller than the smallest one before.
std::vector<LimitCheck> limit_checks(const FlattenReport& report);
/// The same but for limits of strain, which are checked on patterns.
std::vector<LimitCheck> limit_checks(const EvolveReport& report);

/// The limit in words: "at most 2 %".
std::string limit_text(const LimitCheck& check, Unit unit);

}  // namespace planish
