#pragma once

#include <string>

#include <planish/core/unit.h>

#include "core/figure_text.h"
#include "core/number_text.h"

namespace planish {

/// A length on a sheet with its unit, with all its digits after the point: "412.3 mm", "16.23 in".
/// @param decimals of millimetres; of inches one more
inline std::string sheet_length(double millimetres, Unit unit, int decimals) {
  const int more = unit == Unit::mm ? 0 : 1;
  return decimals_text(millimetres / millimetres_per(unit), decimals + more) + " " +
         std::string(to_string(unit));
}

/// The same without zeros at the end: "10 mm", "0.3937 in".
inline std::string short_sheet_length(double millimetres, Unit unit, int decimals) {
  const int more = unit == Unit::mm ? 0 : 1;
  return fixed_text(millimetres / millimetres_per(unit), decimals + more) + " " +
         std::string(to_string(unit));
}

}  // namespace planish
