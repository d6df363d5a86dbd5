#pragma once

#include <array>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <planish/mesh/tri_mesh.h>

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

/// Whether the extension, in either case, is one of the usual ones of models that cannot be read
/// here, such as .step, .glb and .3mf.
bool is_other_model(const std::filesystem::path& path);

/// The bytes of a mesh file. OBJ and OFF: text, shortest digits that read back to the same doubles.
/// PLY: binary little-endian, doubles. STL: binary, floats as the format has it, so that positions
/// are rounded and vertex numbers are lost. Vertices and triangles keep their order.
/// @throws Error non_finite_coordinate (also for what is too large for STL's floats),
///   index_out_of_range
std::string format_mesh(const TriMesh& mesh, MeshFormat format);

/// The bytes of an OBJ file with a texture coordinate at each vertex.
/// @param texture one per vertex
/// @throws Error as format_mesh(), also for coordinates that are not finite
std::string format_textured_obj(const TriMesh& mesh, std::span<const Vec2> texture);

/// A figure of every vertex or of every triangle of a mesh.
struct MeshField {
  std::string name;            ///< letters, digits and underscores
  std::vector<double> values;  ///< one per vertex or triangle, in the order of the mesh
};

/// Figures that are written beside a mesh.
struct MeshFields {
  std::vector<MeshField> vertices = {};   ///< with a value per vertex
  std::vector<MeshField> triangles = {};  ///< with a value per triangle
};

/// The mesh files that can hold fields: PLY, and the XML files of VTK with polygons (.vtp) or cells
/// (.vtu).
enum class FieldFormat { ply, vtp, vtu };

/// "ply", "vtp" or "vtu": also the extension.
std::string_view to_string(FieldFormat format);

/// The text of a mesh file with fields, ASCII: shortest digits that read back to the same doubles.
/// Coordinates and fields are of type double (VTK: Float64).
/// @throws Error as format_mesh(), and option_out_of_range for a field with too many or too few
///   values, or a name with other characters than letters, digits and underscores
std::string format_fields(const TriMesh& mesh, const MeshFields& fields, FieldFormat format);

/// The fields of vertices as comma-separated values: a header line "vertex,x,y,z," and the names of
/// the fields, then a line a vertex. Numbers begin at 0. Values that are not finite are left empty.
/// @throws Error as format_fields()
std::string vertex_fields_csv(const TriMesh& mesh, const MeshFields& fields);

/// The fields of triangles likewise: "triangle,a,b,c," with the numbers of the corners.
/// @throws Error as format_fields()
std::string triangle_fields_csv(const TriMesh& mesh, const MeshFields& fields);

/// Writes format_mesh() in the format that the extension names, whole or not at all.
/// @throws Error as format_mesh(), unsupported_format, file_unwritable
void write_mesh(const std::filesystem::path& path, const TriMesh& mesh);

}  // namespace planish
