#pragma once

#include <array>

#include <planish/core/unit.h>

#include "shell/command.h"

namespace planish::cli {

inline constexpr std::array k_units = {Unit::mm, Unit::cm, Unit::m, Unit::in};

/// --unit, for verbs that write patterns or take lengths.
Flag unit_flag();

/// The unit that the flag names, millimetres without it.
/// @throws UsageError for unknown names
Unit unit_from(const Arguments& arguments);

}  // namespace planish::cli
