#pragma once

#include <string>

#include <planish/flatten/frontier.h>

namespace planish {

/// Strain, rms and largest, of the curve's points over their rms deviation, with the other methods
/// as dots and the limit as a line: inline SVG as log_chart() draws it.
/// Empty where no run moved a vertex.
std::string frontier_chart(const FrontierReport& report);

}  // namespace planish
