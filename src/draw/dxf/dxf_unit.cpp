#include "draw/dxf/dxf_unit.h"

#include <charconv>
#include <cstddef>

#include <planish/core/error.h>

#include "core/number_text.h"

namespace planish {

namespace {

/// Where a value stands, as far as it matters.
struct DxfPlace {
  std::string entity;    ///< "SPLINE"
  std::string variable;  ///< of the header: "$INSUNITS"
};

bool is_length(int code, const DxfPlace& place) {
  if (code >= 10 && code <= 39) return true;
  // Knots of splines are no lengths, bulges of polylines neither.
  if (code == 40) return place.entity != "SPLINE";
  if (code == 42) return place.entity == "STYLE";
  return code == 49;
}

std::string value_in_unit(int code, std::string_view value, const DxfPlace& place, Unit unit) {
  if (code == 70 && place.variable == "$INSUNITS") return "1";
  if (code == 70 && place.variable == "$MEASUREMENT") return "0";
  if (code == 1 && value == "Units: METRIC") return "Units: ENGLISH";
  if (code == 1 && value == "UNITS: METRIC") return "UNITS: ENGLISH";
  if (!is_length(code, place)) return std::string(value);
  double length = 0.0;
  const auto end = std::from_chars(value.data(), value.data() + value.size(), length).ptr;
  if (end != value.data() + value.size()) return std::string(value);
  std::string text = fixed_text(length / millimetres_per(unit), 5);
  if (text.find('.') == std::string::npos) text += ".0";
  return text;
}

/// The next line of a text, which is taken off its beginning.
std::string_view next_line(std::string_view& rest) {
  const std::size_t end = rest.find('\n');
  const std::string_view line = rest.substr(0, end);
  rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
  return line;
}

}  // namespace

std::string dxf_in_unit(std::string dxf, Unit unit) {
  if (unit == Unit::mm) return dxf;
  if (unit != Unit::in)
    throw Error(ErrorCode::unknown_name,
                "a DXF file is in mm or in, not in " + std::string(to_string(unit)));
  std::string result;
  result.reserve(dxf.size());
  DxfPlace place;
  for (std::string_view rest = dxf; !rest.empty();) {
    const std::string_view line = next_line(rest), value = next_line(rest);
    int code = -1;
    std::from_chars(line.data(), line.data() + line.size(), code);
    if (code == 0) place = {std::string(value), ""};
    if (code == 9) place.variable = value;
    result += line;
    result += '\n';
    result += value_in_unit(code, value, place, unit);
    result += '\n';
  }
  return result;
}

}  // namespace planish
