#pragma once

#include "shell/command.h"

namespace planish::cli {

/// @throws UsageError for flags that make sense with one patch only, as they number its vertices
/// @param why_not what the input has, and what to do: "the input has several: take one"
void refuse_single_patch_flags(const Arguments& arguments, const std::string& why_not);

}  // namespace planish::cli
