#pragma once

#include <string>
#include <vector>

#include <planish/core/unit.h>
#include <planish/panels/suggest_panels.h>

#include "cut/cut_flag.h"
#include "shell/command.h"
#include "shell/session.h"

namespace planish::cli {

/// --prefer-cuts and --effort.
std::vector<Flag> panel_flags();

/// What the flags ask for: limits of strain, 2 % rms where there is none, and panel_flags().
/// @throws UsageError, Error option_out_of_range
PanelOptions panel_options_from(const Arguments& arguments);

/// --seams, for verbs that divide without --cut.
Flag fixed_seams_flag();

/// Cuts a product as --seams says, as --cut does with the same words; without the flag it stays.
/// @throws Error as cut_as_asked(); UsageError
CutInput cut_at_fixed_seams(TriMesh mesh, const std::string& path, const Arguments& arguments,
                            Session& session);

/// Writes a note for each flag of panel_flags() that has no effect, as nothing is divided.
void note_idle_panel_flags(const Arguments& arguments, Session& session);

/// Divides a product as panel_options_from() says. Prints each better answer. If the user stops the
/// search, returns the best answer so far, and the run continues.
/// @param path of the product, for the line of progress
/// @param match_seams as PanelOptions has it
/// @throws Error as suggest_panels(); UsageError; Cancelled before there is an answer
PanelSuggestion panels_as_asked(const Patch& patch, const std::string& path,
                                const Arguments& arguments, Session& session,
                                const PanelRules& rules);

/// "2 pieces, 1478 mm of seam, 3 slits"
std::string panels_words(const PanelSuggestion& found, Unit unit);

/// The product cut open along the seams of its panels.
CutInput cut_into_panels(const PanelSuggestion& found);

}  // namespace planish::cli
