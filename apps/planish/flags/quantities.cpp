#include "flags/quantities.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <system_error>

#include <fast_float/fast_float.h>

#include "flags/units.h"
#include "shell/failures.h"
#include "shell/values.h"

namespace planish::cli {

namespace {

struct NumberAndSuffix {
  double number = 0.0;
  std::string suffix = {};
};

/// How the value of a flag must look, as the end of a sentence.
std::string demand_of(Quantity quantity) {
  switch (quantity) {
    case Quantity::number:
    case Quantity::radians:
      return "a number";
    case Quantity::share:
      return "a share such as 0.02 or 2%";
    case Quantity::length:
      return "a length such as 1.5 (model units), 1.5mm, 1.5cm, 1.5m or 1.5in";
    case Quantity::angle:
      return "an angle in degrees such as 5 or 5deg";
  }
  return {};
}

NumberAndSuffix taken_apart(const std::string& flag, const Field& field, Quantity quantity) {
  if (const auto* number = std::get_if<double>(&field)) return {*number};
  if (const auto* number = std::get_if<std::int64_t>(&field)) return {static_cast<double>(*number)};
  const std::string& text = std::get<std::string>(field);
  NumberAndSuffix result;
  const char* const end = text.data() + text.size();
  const auto parsed = fast_float::from_chars(text.data(), end, result.number);
  // Older versions of fast_float read 1e999 as infinity; "inf" is refused further on.
  const bool overflows =
      std::isinf(result.number) && '0' <= parsed.ptr[-1] && parsed.ptr[-1] <= '9';
  if (overflows || parsed.ec == std::errc::result_out_of_range) {
    throw UsageError(flag + " is " + text + " but must be a smaller number");
  }
  if (parsed.ec != std::errc()) {
    throw UsageError(flag + " is \"" + text + "\" but must be " + demand_of(quantity));
  }
  const bool has_blank = end - parsed.ptr > 1 && *parsed.ptr == ' ';  // as in "10 mm"
  result.suffix = std::string(parsed.ptr + (has_blank ? 1 : 0), end);
  return result;
}

/// What one of the suffix is in model units; 0 for what is no unit.
double model_units_per(const std::string& suffix, const Arguments& arguments) {
  const Unit model = unit_from(arguments);
  const auto unit = unit_of_word(suffix);
  if (!unit) return 0.0;
  return *unit == model ? 1.0 : millimetres_per(*unit) / millimetres_per(model);
}

/// What a number with the suffix is to be multiplied with; 0 where the suffix does not fit.
double factor_of(const std::string& suffix, Quantity quantity, const Arguments& arguments) {
  if (suffix.empty()) return 1.0;
  if (quantity == Quantity::share && suffix == "%") return 0.01;
  if (quantity == Quantity::angle && suffix == "deg") return 1.0;
  return quantity == Quantity::length ? model_units_per(suffix, arguments) : 0.0;
}

}  // namespace

Quantity quantity_of(std::string_view option) {
  if (option == "max_strain" || option == "max_rms_strain") return Quantity::share;
  if (option == "max_deviation" || option == "clearance" || option == "border")
    return Quantity::length;
  constexpr std::array<std::string_view, 4> in_radians = {"target_e_max", "switch_e_max",
                                                          "switch_fall", "enough"};
  if (std::find(in_radians.begin(), in_radians.end(), option) != in_radians.end())
    return Quantity::radians;
  return option == "min_angle" || option == "crease" ? Quantity::angle : Quantity::number;
}

ValueType type_of(Quantity quantity) {
  switch (quantity) {
    case Quantity::number:
      return ValueType::number;
    case Quantity::share:
      return ValueType::share;
    case Quantity::length:
      return ValueType::length;
    case Quantity::angle:
      return ValueType::angle;
    case Quantity::radians:
      return ValueType::radians;
  }
  return ValueType::number;
}

std::string forms_of(Quantity quantity) {
  switch (quantity) {
    case Quantity::number:
    case Quantity::radians:
      return {};
    case Quantity::share:
      return "0.02 or 2%";
    case Quantity::length:
      return "1.5 or 1.5mm";
    case Quantity::angle:
      return "5 or 5deg";
  }
  return {};
}

double quantity_value(const std::string& flag, const Field& field, Quantity quantity, Range range,
                      const Arguments& arguments) {
  const auto [number, suffix] = taken_apart(flag, field, quantity);
  const std::string text = field_text(field);
  const double factor = factor_of(suffix, quantity, arguments);
  if (factor == 0.0) {
    throw UsageError(flag + " is \"" + text + "\" but must be " + demand_of(quantity));
  }
  // Divided, 2% is the same number as 0.02.
  const double value = suffix == "%" ? number / 100.0 : number * factor;
  // 1 is meant as 1 % more often than as 100 %.
  if (quantity == Quantity::share && suffix.empty() && value >= range.max) {
    throw Error(ErrorCode::option_out_of_range,
                flag + " is " + text + " but must be " + demand_of(quantity) +
                    (std::isfinite(value) ? "; did you mean " + text + "%?" : ""));
  }
  check_range(flag, value, range);
  return value;
}

}  // namespace planish::cli
