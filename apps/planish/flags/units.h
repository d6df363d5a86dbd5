#pragma once

#include <array>
#include <optional>
#include <string_view>

#include <planish/core/unit.h>

#include "shell/command.h"

namespace planish::cli {

inline constexpr std::array k_units = {Unit::mm, Unit::cm, Unit::dm, Unit::m, Unit::in};

/// --unit, for verbs that write patterns or take lengths.
Flag unit_flag();

/// The unit that a word names: its short name, or metre, millimeters, inch and the like, in
/// capitals or not. Nothing for other words.
std::optional<Unit> unit_of_word(std::string_view word);

/// The unit that the flag names, millimetres without it.
/// @throws UsageError for unknown names
Unit unit_from(const Arguments& arguments);

}  // namespace planish::cli
