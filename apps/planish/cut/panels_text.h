#pragma once

#include <map>
#include <string>
#include <vector>

#include <planish/core/unit.h>
#include <planish/panels/suggest_panels.h>

#include "cut/cut_flag.h"

namespace planish::cli {

/// A row for each panel, as people read it.
/// @param cut the product cut open (cut_into_panels())
std::string panels_text(const PanelSuggestion& found, const TriMesh& cut, Unit unit);

/// The same as one JSON object (docs/command-line.md).
/// @param files role -> path of what was written
std::string panels_json(const PanelSuggestion& found, const CutInput& cut, Unit unit,
                        const std::map<std::string, std::string>& files);

/// The file that --cut takes: the seams as lines of an OBJ file.
/// @param fixed those that were cut before
std::string panel_lines(const PanelSuggestion& found, const std::vector<std::vector<Vec3>>& fixed,
                        const Arguments& arguments);

}  // namespace planish::cli
