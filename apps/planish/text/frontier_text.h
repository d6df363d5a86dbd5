#pragma once

#include <string>

#include <planish/flatten/frontier.h>

namespace planish::cli {

/// A frontier as people read it, at most 80 columns wide.
std::string frontier_text(const FrontierReport& report);

}  // namespace planish::cli
