#pragma once

#include "shell/command.h"

namespace planish::cli {

/// --material, which stands for --max-strain.
Flag material_flag();

/// The limit of strain of the material that --material names.
/// @throws UsageError for unknown names, and with --max-strain beside it
double strain_of_material(const Arguments& arguments);

}  // namespace planish::cli
