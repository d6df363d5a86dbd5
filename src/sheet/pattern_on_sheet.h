#pragma once

#include <string>

#include <planish/flatten/flatten.h>
#include <planish/mesh/tri_mesh.h>
#include <planish/pattern/pattern_options.h>

#include "sheet/piece/placed_pattern.h"
#include "sheet/sheet_label.h"

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
