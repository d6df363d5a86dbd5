#pragma once

#include <string>
#include <vector>

#include <planish/draw/drawing.h>
#include <planish/flatten/flatten.h>
#include <planish/sheet/pattern_geometry.h>

namespace planish {

/// The layer "label": two test squares, name, sizes, unit, scale and hash.
/// @param lines what the colours of lines mean, as line_words() says it
Layer sheet_label(const UnfoldReport& unfold, const PatternGeometry& pattern,
                  const std::string& lines);

/// The words of the layer "label" but for the name.
std::vector<std::string> sheet_notes(const UnfoldReport& unfold, const PatternGeometry& pattern,
                                     const std::string& lines);

/// The layer "legend": what the colours of the strain map mean, beside the label.
Layer map_legend(const UnfoldReport& unfold);

}  // namespace planish
