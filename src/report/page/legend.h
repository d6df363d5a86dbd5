#pragma once

#include <span>
#include <string>
#include <vector>

#include <planish/draw/color.h>

namespace planish {

/// What the words under the ends and the middle of a colour scale say, HTML.
struct LegendLabels {
  std::string low, middle, high;
};

/// A colour scale as HTML: a bar of equal fields over its labels.
std::string legend(std::span<const Color> fields, const LegendLabels& labels);

/// The legend of a map of the limit used up: ten fields up to the limit, and one apart for what is
/// beyond. Its labels stand where limit_style() puts them.
std::string limit_legend();

/// The whole of a colour map, finely divided.
std::vector<Color> fields_of(ColorMap map);

/// The 21 colours of a strain map.
std::vector<Color> strain_map_fields();

}  // namespace planish
