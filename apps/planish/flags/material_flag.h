#pragma once

#include <string>

#include "shell/command.h"

namespace planish::cli {

/// --material, which stands for --max-strain.
Flag material_flag();

/// The name of the material of --material as materials() has it; empty without the flag.
/// @throws UsageError
std::string material_from(const Arguments& arguments);

/// The limit of strain of the material that --material names.
/// @throws UsageError for unknown names, and with --max-strain beside it
double strain_of_material(const Arguments& arguments);

}  // namespace planish::cli
