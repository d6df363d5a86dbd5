#pragma once

#include <array>
#include <string>
#include <string_view>

#include <planish/draw/color_map.h>
#include <planish/draw/drawing.h>
#include <planish/report/flatten.h>

namespace planish {

/// The layers of pattern_sheet(), in the order that they are drawn.
inline constexpr std::array<std::string_view, 3> k_sheet_layers = {"strain", "cut", "label"};

/// The pattern as a sheet in millimetres, with a margin, in three layers: "strain" (every triangle
/// in the colour of its signed strain, neighbours of one colour joined), on top of it "cut" (the
/// outline), and "label" beside it (name, sizes, unit, a 50 mm test square, what the colours mean).
/// @param mesh the patch that was unfolded
Drawing pattern_sheet(const TriMesh& mesh, const UnfoldReport& unfold, const std::string& name);

/// The strain at which the strain map's colours end: the 99th percentile of the edges' strain,
/// rounded up to 1, 2 or 5 times a power of ten, at least 0.1 %.
double strain_map_limit(const EdgeStrain& strain);

}  // namespace planish
