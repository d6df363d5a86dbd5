#pragma once

#include "shell/command.h"

namespace planish::cli {

/// What the files of projects say that they are.
inline constexpr const char* k_project_kind = "planish project";
inline constexpr int k_project_version = 1;

/// What the user typed, with what a project of the app says (docs/app.md) where the one input of
/// `flatten` is its file: the model beside it, its lines and options. Flags that were typed count
/// more; --cut adds to the lines.
/// @throws Error malformed_file for another version, a project of another model, and what is no
///   project; file_not_found where the model does not lie beside it
Arguments with_project(const Command& command, Arguments arguments);

}  // namespace planish::cli
