#pragma once

#include <filesystem>
#include <string>

#include <planish/io/mesh_format.h>

namespace planish::cli {

/// The path of a folder to be written into.
/// @throws Error file_unwritable where something that is no folder stands in its place, or where
///   the user may not write
std::filesystem::path output_folder(const std::string& folder);

/// The format that results of a mesh are written in. STL holds neither doubles nor the order of
/// vertices: what comes as STL goes as OBJ.
MeshFormat output_format(MeshFormat input);

}  // namespace planish::cli
