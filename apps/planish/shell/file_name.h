#pragma once

#include <string>

namespace planish::cli {

/// "part" of folder/part.obj.
std::string stem_of(const std::string& path);

/// ".OBJ" of folder/part.OBJ.
std::string extension_of(const std::string& path);

/// ".obj" of folder/part.OBJ.
std::string lower_extension(const std::string& path);

}  // namespace planish::cli
