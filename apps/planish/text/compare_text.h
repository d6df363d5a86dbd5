#pragma once

#include <string>

#include <planish/flatten/compare.h>

namespace planish::cli {

/// The comparison as people read it, at most 80 columns wide: a table with a row for the input and
/// for each method, then in words what each did and which to trust.
std::string compare_text(const CompareReport& report);

}  // namespace planish::cli
