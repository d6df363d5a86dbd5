#pragma once

#include <string>
#include <vector>

#include <planish/io/model.h>

#include "text/lengths.h"

namespace planish::cli {

/// What preparing a model did and found, a sentence each.
std::vector<std::string> work_notes(const ModelWork& work, const ShownLengths& lengths);

}  // namespace planish::cli
