#pragma once

#include <array>
#include <optional>

#include <planish/mesh/patch.h>
#include <planish/pattern/pattern_options.h>

#include "shell/command.h"
#include "shell/session.h"

namespace planish::cli {

/// Where seams match, curves keep lengths so well that both sides stay within 0.01 mm: as LineFit
/// has it, millimetres.
inline constexpr double k_length_tolerance_of_seams = 0.003;

/// Allowance, notches, grain, marks and labels, for verbs that write patterns.
FlagGroup annotation_flags();

/// What the flags and their files ask for, but for files that are drawings.
/// @param writes_sheet whether a pattern is drawn at all
/// @throws UsageError, Error option_out_of_range, and as read_rows(), notches_in() and the like
PatternOptions annotations_from(const Arguments& arguments, bool writes_sheet);

/// That of --sheet-unit: mm or in.
/// @throws UsageError
Unit sheet_unit_from(const Arguments& arguments);

/// The ends of --fold, as UnfoldOptions has them.
/// @throws UsageError
std::optional<std::array<Index, 2>> fold_ends_from(const Arguments& arguments);

/// Adds what the files of --notches, --marks and --inner-lines that are drawings (.obj) ask for.
/// @throws Error as read_drawn_notches(), read_drawn_marks() and read_drawn_lines()
PatternOptions with_drawn_annotations(PatternOptions options, const Arguments& arguments,
                                      const Patch& patch, Session& session);

}  // namespace planish::cli
