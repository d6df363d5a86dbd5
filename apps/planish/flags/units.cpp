#include "flags/units.h"

#include <vector>

#include "shell/values.h"

namespace planish::cli {

namespace {

std::vector<std::string> unit_names() {
  std::vector<std::string> names;
  names.reserve(k_units.size());
  for (const Unit unit : k_units) {
    names.emplace_back(to_string(unit));
  }
  return names;
}

}  // namespace

Flag unit_flag() {
  return {
      "--unit", "UNIT", "what one unit of the mesh is: " + list_of(unit_names()) + " (default mm)",
      0,        false,  {.choices = unit_names(), .standard = "mm"}};
}

Unit unit_from(const Arguments& arguments) {
  return unit_named(known_name("unit", arguments.value_or("--unit", "mm"), unit_names()));
}

}  // namespace planish::cli
