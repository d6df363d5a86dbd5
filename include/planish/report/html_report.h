#pragma once

#include <string>

#include <planish/draw/color_map.h>
#include <planish/report/compare.h>
#include <planish/report/flatten.h>
#include <planish/report/frontier.h>

namespace planish {

/// The main job's result as one HTML page that needs nothing else: pictures of the patch before and
/// after, coloured by angle defect at one scale, the pattern coloured by strain, the convergence
/// curve and the table of figures. No scripts, no network. Text from outside is escaped.
/// @param colors diverging: signed defect; paper: |defect|, blue to red as the 2010 paper has it
std::string html_report(const FlattenReport& report, ColorMap colors = ColorMap::diverging);

/// A comparison as such a page: the table of all methods, charts of energy, e_max and e_avg against
/// sweeps and seconds, pictures of what each method made of patch and pattern at one scale, and
/// where Laplacian directions help (direction.h).
std::string html_report(const CompareReport& report);

/// A frontier as such a page: the chart of frontier_svg() and a table of all points.
std::string html_report(const FrontierReport& report);

}  // namespace planish
