#pragma once

#include <string>

#include <planish/measure/material.h>

#include <planish_json/json.h>

namespace planish::cli {

/// Whether the word is the path of a material file, and no name: one that ends with .json.
bool is_material_file(const std::string& word);

/// Reads a material of one's own (docs/materials.md), strictly: keys that are not known are errors.
/// @throws Error file_unreadable, too_large, malformed_file naming the place in the file, as in
///   "stretch.usual.strain"
Material read_material_file(const std::string& path);

/// What the file of a material says: read_material_file() makes the same of it.
Json material_json(const Material& material);

}  // namespace planish::cli
