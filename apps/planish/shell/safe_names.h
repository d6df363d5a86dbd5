#pragma once

#include <string>
#include <vector>

namespace planish::cli {

/// Names of folders and files that are sound everywhere and lead nowhere else: letters, digits,
/// dots, hyphens, underscores and what is not ASCII; other characters become underscores. No two
/// are equal, also where the system takes small and large letters for the same.
std::vector<std::string> safe_names(const std::vector<std::string>& names);

}  // namespace planish::cli
