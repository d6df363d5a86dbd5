// What the program knows of materials, and what a file of one's own says.

#include <planish/measure/material.h>

#include "commands/commands.h"
#include "flags/material_flag.h"
#include "model/material_file.h"
#include "model/material_text.h"
#include "shell/session.h"

namespace planish::cli {

namespace {

CommandResult run_materials(const Arguments& arguments, Session&) {
  if (arguments.operands.empty())
    return {materials_table(materials()), materials_json(materials())};
  const Material material = material_of_word(arguments.operands.front());
  return {material_text(material), materials_json({&material, 1})};
}

}  // namespace

Command materials_command() {
  return {"materials",
          "strain that materials take, and the sources of these figures",
          "[NAME|FILE]",
          "Lists how far each material that --material knows can be stretched and compressed, on "
          "99 % of the area and at most, as fractions of the length on the form. For one material, "
          "by its name or a .json file of your own, also prints the source of each figure. With "
          "--json prints each material in the form of such a file.",
          {"NAME|FILE"},
          {},
          {"planish materials", "planish materials leather-lasted", "planish materials my.json",
           "planish materials --json"},
          run_materials,
          true,
          false,
          {{.type = ValueType::name, .choices = material_names(), .extensions = {"json"}}}};
}

}  // namespace planish::cli
