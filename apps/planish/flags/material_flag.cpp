#include "flags/material_flag.h"

#include <planish/measure/material.h>

#include "shell/failures.h"
#include "shell/values.h"

namespace planish::cli {

namespace {

std::vector<std::string> material_names() {
  std::vector<std::string> names;
  for (const Material& material : materials())
    names.emplace_back(material.name);
  return names;
}

std::vector<std::string> names_with_strains() {
  std::vector<std::string> names;
  for (const Material& material : materials())
    names.push_back(std::string(material.name) + " " + shortest(100.0 * material.max_strain) + "%");
  return names;
}

}  // namespace

Flag material_flag() {
  return {"--material",
          "NAME",
          "instead of --max-strain: the strain that this material takes, " +
              list_of(names_with_strains()),
          0,
          false,
          {.choices = material_names()}};
}

std::string material_from(const Arguments& arguments) {
  if (!arguments.has("--material")) return {};
  const std::string& name = arguments.flags.at("--material");
  if (!name.empty() && name.find_first_not_of("0123456789.,%") == std::string::npos) {
    throw UsageError("--material is " + name + " but must be a name, " + list_of(material_names()) +
                     "; for another strain give --max-strain " + name + ", or --max-strain " +
                     name + "@p99 for 99 % of the area as with a material");
  }
  try {
    return known_name("material", name, material_names());
  } catch (const UsageError& error) {
    throw UsageError(std::string(error.what()) +
                     "; for another one give its strain, as --max-strain 0.5%@p99; plywood, card "
                     "and sheet metal hardly stretch: begin with steel");
  }
}

double strain_of_material(const Arguments& arguments) {
  if (arguments.has("--max-strain")) {
    throw UsageError(
        "--material and --max-strain both say what strain is allowed: give one of them");
  }
  return material_named(material_from(arguments)).max_strain;
}

}  // namespace planish::cli
