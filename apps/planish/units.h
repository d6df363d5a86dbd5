#pragma once

#include <planish/report/unit.h>

#include "command.h"

namespace planish::cli {

/// --unit, for verbs that write patterns.
Flag unit_flag();

/// The unit that the flag names, millimetres without it.
/// @throws UsageError for unknown names
Unit unit_from(const Arguments& arguments);

}  // namespace planish::cli
