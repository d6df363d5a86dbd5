#pragma once

#include <string>
#include <vector>

#include <planish/io/model.h>

#include "text/lengths.h"

namespace planish::cli {

/// What preparing a model did and found, a sentence each.
std::vector<std::string> work_notes(const ModelWork& work, const ShownLengths& lengths);

/// "a, b, c and 38 more"
std::string list_of_some(const std::vector<std::string>& names);

}  // namespace planish::cli
