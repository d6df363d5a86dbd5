#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include <planish/core/unit.h>
#include <planish/io/read_mesh.h>

#include "shell/command.h"
#include "shell/session.h"

namespace planish::cli {

inline constexpr std::array k_units = {Unit::mm, Unit::cm, Unit::dm, Unit::m, Unit::in};

/// --unit, for verbs that write patterns or take lengths.
Flag unit_flag();

/// The unit that a word names: its short name, or metre, millimeters, inch and the like, in
/// capitals or not. Nothing for other words.
std::optional<Unit> unit_of_word(std::string_view word);

/// The unit of a run: that which the flag names, without it that which the input files state,
/// without both millimetres.
/// @throws UsageError for unknown names
Unit unit_from(const Arguments& arguments);

/// The unit of a run, and whether the flag says it: then no file has a say.
struct RunUnit {
  Unit unit = Unit::mm;
  bool is_asked = false;
};
RunUnit run_unit_from(const Arguments& arguments);

/// A mesh in the unit of the run: one whose file states another unit is scaled, with a note, unless
/// the flag says what its unit is.
/// @param path of its file, for the note
ReadResult in_run_unit(ReadResult file, RunUnit unit, const std::string& path, Session& session);

}  // namespace planish::cli
