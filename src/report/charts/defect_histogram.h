#pragma once

#include <span>
#include <string>

namespace planish {

/// How many vertices have how large a |defect|, before and after: pairs of bars over half decades,
/// as inline SVG, with the bound of flattenable (k_flattenable_e_max) as a line. What is below
/// 1e-12 counts to the lowest bar. Empty where there are no vertices.
/// @param before, after defects of the inner vertices, radians
std::string defect_histogram(std::span<const double> before, std::span<const double> after);

}  // namespace planish
