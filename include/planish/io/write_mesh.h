#pragma once

#include <filesystem>
#include <string>

#include <planish/io/mesh_format.h>
#include <planish/mesh/tri_mesh.h>

namespace planish {

/// The bytes of a mesh file. OBJ and OFF: text, shortest digits that read back to the same doubles.
/// PLY: binary little-endian, doubles. STL: binary, floats as the format has it, so that positions
/// are rounded and vertex numbers are lost. Vertices and triangles keep their order.
std::string format_mesh(const TriMesh& mesh, MeshFormat format);

/// Writes format_mesh() in the format that the extension names, whole or not at all.
/// @throws Error unsupported_format, file_unwritable
void write_mesh(const std::filesystem::path& path, const TriMesh& mesh);

}  // namespace planish
