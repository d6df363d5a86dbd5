#pragma once

#include <map>
#include <string>

#include <planish/core/unit.h>
#include <planish/unfold/suggest_cuts.h>

namespace planish::cli {

/// What was suggested, as people read it.
/// @param options of the search
std::string suggestion_text(const CutSuggestion& suggestion, const SuggestOptions& options,
                            Unit unit);

/// The same as one JSON object (docs/command-line.md).
/// @param files role -> path of what was written
std::string suggestion_json(const CutSuggestion& suggestion, const SuggestOptions& options,
                            Unit unit, const std::map<std::string, std::string>& files);

/// The file that --cut takes: a cut a line, what it is for in comments.
std::string suggestion_file(const CutSuggestion& suggestion, Unit unit);

}  // namespace planish::cli
