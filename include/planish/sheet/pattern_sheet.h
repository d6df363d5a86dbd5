#pragma once

#include <array>
#include <string>
#include <string_view>

#include <planish/draw/color.h>
#include <planish/draw/drawing.h>
#include <planish/flatten/flatten.h>
#include <planish/sheet/pattern_geometry.h>

namespace planish {

/// The layers of pattern_sheet(), in the order that they are drawn: what is cut comes last, as it
/// frees the piece. All are always there, and the lines and words of no two of them share a colour.
inline constexpr std::array<std::string_view, 12> k_sheet_layers = {
    "strain",   "seam",       "notch", "grain",  "fold", "drill",
    "internal", "annotation", "label", "legend", "hole", "cut"};

/// In maps of the limit used up, the colour of what is beyond. Eyes without red, green or blue
/// cones too tell orange from all colours of ColorMap::pale, which what is within has.
inline constexpr Color k_beyond_limit = {240, 82, 10};

/// The pattern as a sheet in millimetres, with a margin: "strain" (every triangle in the colour of
/// its signed strain, or where an edge has a limit of strain, of the share of it that its edges use
/// up; neighbours of one colour joined), over it "seam" (with an allowance the outline), "notch",
/// "grain", "fold", "drill" (match marks too), "internal" (inner lines) and "annotation" (the
/// piece's own label) as the options ask, "hole" and "cut" (the outlines of holes and of the piece,
/// or with an allowance the lines within and around these), below the pattern "label": name, sizes,
/// unit, scale, a hash of the pattern, test squares of 50 mm and 2 in; and "legend", what the
/// colours mean.
/// @param patch that was unfolded
/// @param name of the patch; that of the piece too where the options have none
/// @throws Error as pattern_geometry()
Drawing pattern_sheet(const Patch& patch, const UnfoldReport& unfold, const std::string& name,
                      const PatternOptions& options = {});

/// The same of a pattern that has been made.
/// @param mesh that was laid flat
/// @param pattern what pattern_geometry() makes of both
Drawing pattern_sheet(const TriMesh& mesh, const UnfoldReport& unfold,
                      const PatternGeometry& pattern);

/// The same, but half a piece whose options ask for it is drawn whole, its fold a line inside.
/// @throws Error as with_folds_opened()
Drawing sheet_to_cut(const TriMesh& mesh, const UnfoldReport& unfold,
                     const PatternGeometry& pattern);

/// The sheet without the strain map and its legend, whose layers stay and are empty.
Drawing without_map(Drawing sheet);

/// The strain at which the strain map's colours end: the 99th percentile of the edges' strain,
/// rounded up to 1, 2 or 5 times a power of ten, at least 0.1 %.
double strain_map_limit(const EdgeStrain& strain);

}  // namespace planish
