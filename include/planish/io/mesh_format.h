#pragma once

#include <array>
#include <filesystem>
#include <string_view>

namespace planish {

/// The mesh files that are read and written.
enum class MeshFormat { obj, ply, stl, off };

/// All of them.
inline constexpr std::array k_mesh_formats = {MeshFormat::obj, MeshFormat::ply, MeshFormat::stl,
                                              MeshFormat::off};

/// "obj", "ply", "stl" or "off": also the extension.
std::string_view to_string(MeshFormat format);

/// The format that the extension of a path names, in either case.
/// @throws Error unsupported_format naming the extensions that are known
MeshFormat mesh_format_of(const std::filesystem::path& path);

}  // namespace planish
