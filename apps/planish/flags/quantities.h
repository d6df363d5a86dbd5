#pragma once

#include <string>
#include <string_view>

#include <planish/core/range.h>

#include "shell/command.h"

namespace planish::cli {

/// What a number is of, which says what may stand behind it.
enum class Quantity {
  number,   ///< nothing
  share,    ///< %
  length,   ///< a unit; model units without it
  angle,    ///< deg, which it is in without it too
  radians,  ///< nothing
};

/// That of an option of a method, as its describe() names it.
Quantity quantity_of(std::string_view option);

ValueType type_of(Quantity quantity);

/// How values may be written, for the help: "0.02 or 2%"; empty for plain numbers.
std::string forms_of(Quantity quantity);

/// The number that the value of a flag is or says: a fraction, model units, degrees.
/// @param arguments say with --unit what a model unit is
/// @throws UsageError where it is no such number, Error option_out_of_range
double quantity_value(const std::string& flag, const Field& field, Quantity quantity, Range range,
                      const Arguments& arguments);

}  // namespace planish::cli
