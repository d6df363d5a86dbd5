#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <planish/report/json_report.h>

#include "shell/session.h"

namespace planish::cli {

/// The paths of what was written.
std::string written_text(const std::vector<OutputFile>& files);

/// The same of one run of flatten: what each file is for, and last the path of the page to open.
/// @param paths by role, as paths_in() (output/flatten_files.h) gives them
/// @param files all that was written: those without a role are listed by their paths
std::string written_text(const std::filesystem::path& folder, const WrittenFiles& paths,
                         const std::vector<OutputFile>& files);

}  // namespace planish::cli
