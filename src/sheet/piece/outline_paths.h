#pragma once

#include <vector>

#include <planish/draw/drawing.h>
#include <planish/pattern/pattern_options.h>

#include "sheet/piece/placed_pattern.h"

namespace planish {

/// What is cut. Along a fold, where nothing is, the line is open: the fold line is drawn there.
std::vector<Path> cut_paths(const PlacedPattern& pattern, const PatternOptions& options,
                            const Stroke& stroke);

/// The line of a fold, which there must be: of a half from cut line to cut line, through the
/// allowances at its ends.
Polygon fold_line(const PlacedPattern& pattern, const PatternOptions& options);

/// The outline where there is an allowance, but for the stretches that have none: the cut line, or
/// the fold line, is drawn there.
std::vector<Path> seam_paths(const PlacedPattern& pattern, const PatternOptions& options,
                             const Stroke& stroke);

}  // namespace planish
