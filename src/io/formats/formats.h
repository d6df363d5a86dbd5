#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include <planish/io/mesh_format.h>
#include <planish/io/read_mesh.h>

namespace planish {

/// ".obj" of part.OBJ.
std::string lower_extension(const std::filesystem::path& path);

/// As mesh_format_of(). Where another program wrote the file, the error says what to export
/// instead.
/// @throws Error unsupported_format
MeshFormat readable_format_of(const std::filesystem::path& path);

// One pair a format. Readers take the bytes of a file that is not empty; writers take a mesh whose
// positions are finite and whose indices are in range.

ReadResult parse_obj(std::string_view bytes, std::string_view name, const ReadOptions& options);
ReadResult parse_ply(std::string_view bytes, std::string_view name, const ReadOptions& options);
ReadResult parse_stl(std::string_view bytes, std::string_view name, const ReadOptions& options);
ReadResult parse_off(std::string_view bytes, std::string_view name, const ReadOptions& options);

/// @param texture one coordinate per vertex, or none at all
std::string format_obj(const TriMesh& mesh, std::span<const Vec2> texture = {});
std::string format_ply(const TriMesh& mesh);
std::string format_stl(const TriMesh& mesh);
std::string format_off(const TriMesh& mesh);

/// Refuses what would be read back as something else, or not at all.
/// @throws Error as format_mesh()
void check_writable(const TriMesh& mesh, MeshFormat format);

}  // namespace planish
