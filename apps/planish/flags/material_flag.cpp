#include "flags/material_flag.h"

#include <planish/measure/material.h>

#include "model/material_file.h"
#include "shell/failures.h"
#include "shell/values.h"

namespace planish::cli {

Flag material_flag() {
  return {"--material",
          "NAME",
          "use the limit of a material instead of --max-strain: " + list_of(material_names()) +
              " or a .json file of your own; planish materials lists their limits",
          0,
          false,
          {.choices = material_names(), .extensions = {"json"}}};
}

Material material_of_word(const std::string& word) {
  if (is_material_file(word)) return read_material_file(word);
  return material_named(known_name("material", word, material_names()));
}

std::optional<Material> material_from(const Arguments& arguments) {
  if (!arguments.has("--material")) return std::nullopt;
  if (arguments.has("--max-strain")) {
    throw UsageError(
        "--material and --max-strain both say what strain is allowed: give one of them");
  }
  const std::string word = arguments.text("--material");
  if (!word.empty() && word.find_first_not_of("0123456789.,%") == std::string::npos) {
    throw UsageError("--material is " + word + " but must be a name, " + list_of(material_names()) +
                     "; for another strain give --max-strain " + word + ", or --max-strain " +
                     word + "@p99 for 99 % of the area as with a material");
  }
  try {
    return material_of_word(word);
  } catch (const UsageError& error) {
    throw UsageError(std::string(error.what()) +
                     "; for another one give its strain, as --max-strain 0.5%@p99, or a .json file "
                     "(docs/materials.md); plywood and card hardly stretch: begin with steel");
  }
}

std::string material_name_from(const Arguments& arguments) {
  const auto material = material_from(arguments);
  return material ? material->name : "";
}

StrainLimits one_limit_of_material(const Arguments& arguments) {
  const Material material = material_from(arguments).value();
  const StrainLimits limits = limits_of(material);
  if (limits != StrainLimits{.p99 = limits.p99}) {
    throw UsageError("--material " + material.name +
                     " has more limits than one, and the curve marks one: give --max-strain");
  }
  return limits;
}

}  // namespace planish::cli
