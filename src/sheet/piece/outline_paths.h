#pragma once

#include <vector>

#include <planish/draw/drawing.h>
#include <planish/sheet/pattern_geometry.h>

namespace planish {

/// What is cut.
struct CutPaths {
  std::vector<Path> outer;  ///< along a fold, where nothing is cut, open: the fold line is there
  std::vector<Path> holes;
};
CutPaths cut_paths(const PatternGeometry& pattern, const Stroke& outer, const Stroke& hole);

/// The line of a fold, which there must be: of a half from cut line to cut line, through the
/// allowances at its ends.
Polygon fold_line(const PatternGeometry& pattern);

/// The outline where there is an allowance, but for the stretches that have none: the cut line, or
/// the fold line, is drawn there.
std::vector<Path> seam_paths(const PatternGeometry& pattern, const Stroke& stroke);

}  // namespace planish
