#pragma once

#include <optional>

#include <planish/flatten/flatten.h>

#include "shell/command.h"
#include "shell/session.h"

namespace planish::cli {

/// Of the patch laid flat as it is; nothing where that is not possible and no limit was asked for.
/// @throws Error what stands in the way, where a limit was asked for
std::optional<StrainAsDesigned> strain_of(const Patch& patch, const StrainLimits& limits,
                                          Session& session);

/// Whether `measure` is asked for a table: of several inputs, of a folder, or with --csv.
bool measures_several(const Arguments& arguments);

/// Measures all files, and all mesh files of folders, a line each. A file that fails does not end
/// the others; the exit code is 1 at the end.
/// @throws UsageError for flags that go with one file only
CommandResult measure_files(const Arguments& arguments, Session& session);

}  // namespace planish::cli
