#pragma once

#include <string>

#include <planish/core/unit.h>
#include <planish/draw/drawing.h>
#include <planish/unfold/suggest_cuts.h>

namespace planish {

/// The pattern without darts as pattern_sheet() draws it, its outline dark, and on it the layer
/// "suggested": every dart in red with its number among the cuts, from 1, at the tip. What makes a
/// disk of the mesh is outline.
Drawing cut_sheet(const CutSuggestion& suggestion, Unit unit, const std::string& name);

}  // namespace planish
