#pragma once

#include <string>

#include <planish/flatten/product.h>

namespace planish::cli {

/// A line on a finished patch.
std::string patch_line(const PatchResult& patch);

/// How many patches were made from others; empty where none was.
std::string twins_text(const ProductReport& report);

/// The seams as people read them.
/// @param is_batch seams between files were not searched
std::string seams_text(const ProductReport& report, bool is_batch);

}  // namespace planish::cli
