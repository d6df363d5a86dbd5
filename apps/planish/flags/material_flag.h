#pragma once

#include <optional>
#include <string>

#include <planish/measure/material.h>

#include "shell/command.h"

namespace planish::cli {

/// --material, which stands for --max-strain.
Flag material_flag();

/// The material that a word names: one of materials(), or that of a .json file.
/// @throws UsageError for unknown names, Error as read_material_file()
Material material_of_word(const std::string& word);

/// The material of --material; nothing without the flag.
/// @throws UsageError for unknown names, and with --max-strain beside it; Error as
///   read_material_file()
std::optional<Material> material_from(const Arguments& arguments);

/// Its name; empty without the flag.
/// @throws as material_from()
std::string material_name_from(const Arguments& arguments);

/// The limits of the material of --material, where it is one limit.
/// @throws UsageError for one that has several; as material_from()
StrainLimits one_limit_of_material(const Arguments& arguments);

}  // namespace planish::cli
