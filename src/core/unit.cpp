#include <array>
#include <string>

#include <planish/core/error.h>
#include <planish/core/unit.h>

namespace planish {

namespace {

struct UnitEntry {
  Unit unit;
  std::string_view name;
  double millimetres;
};

constexpr std::array<UnitEntry, 5> k_units = {{
    {Unit::mm, "mm", 1.0},
    {Unit::cm, "cm", 10.0},
    {Unit::dm, "dm", 100.0},
    {Unit::m, "m", 1000.0},
    {Unit::in, "in", 25.4},
}};

const UnitEntry& entry_of(Unit unit) {
  return k_units[static_cast<std::size_t>(unit)];
}

}  // namespace

std::string_view to_string(Unit unit) {
  return entry_of(unit).name;
}

double millimetres_per(Unit unit) {
  return entry_of(unit).millimetres;
}

Unit unit_named(std::string_view name) {
  for (const UnitEntry& entry : k_units) {
    if (entry.name == name) return entry.unit;
  }
  throw Error(ErrorCode::unknown_name,
              "no unit is called '" + std::string(name) + "'; there are mm, cm, dm, m and in");
}

}  // namespace planish
