#pragma once

#include <string>

#include <planish/mesh/tri_mesh.h>
#include <planish/report/flatten.h>
#include <planish/report/pattern_options.h>

#include "report/placed_pattern.h"
#include "report/sheet_label.h"

namespace planish {

/// A pattern where pattern_sheet() draws it.
struct PatternOnSheet {
  PlacedPattern pattern;
  PatternOptions options;  ///< those that are possible: no allowance around what overlaps itself
  SheetFacts facts;
  Vec2 size;  ///< of the sheet, millimetres
};

/// @throws Error as pattern_sheet()
PatternOnSheet pattern_on_sheet(const TriMesh& mesh, const UnfoldReport& unfold,
                                const std::string& name, const PatternOptions& wanted);

}  // namespace planish
