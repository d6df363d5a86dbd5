#include <array>
#include <cmath>
#include <limits>

#include <planish/core/error.h>
#include <planish/io/mesh_format.h>
#include <planish/io/write_file.h>

#include "io/formats/formats.h"

namespace planish {
namespace {

/// The largest coordinate that a format can hold.
double largest_of(MeshFormat format) {
  return format == MeshFormat::stl ? static_cast<double>(std::numeric_limits<float>::max())
                                   : std::numeric_limits<double>::max();
}

}  // namespace

void check_writable(const TriMesh& mesh, MeshFormat format) {
  const double largest = largest_of(format);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const Vec3 p = mesh.positions[i];
    for (const double c : {p.x, p.y, p.z}) {
      if (std::abs(c) <= largest) continue;
      throw Error(ErrorCode::non_finite_coordinate,
                  "vertex " + std::to_string(i) + " has a coordinate that " +
                      std::string(to_string(format)) + " files cannot hold",
                  {.path = {}, .first = i});
    }
  }
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    for (const Index v : mesh.triangles[i]) {
      if (v < mesh.positions.size()) continue;
      throw Error(ErrorCode::index_out_of_range,
                  "triangle " + std::to_string(i) + " refers to vertex " + std::to_string(v) +
                      " but the mesh has " + std::to_string(mesh.positions.size()),
                  {.path = {}, .first = i});
    }
  }
}

std::string format_mesh(const TriMesh& mesh, MeshFormat format) {
  check_writable(mesh, format);
  switch (format) {
    case MeshFormat::obj:
      return format_obj(mesh);
    case MeshFormat::ply:
      return format_ply(mesh);
    case MeshFormat::stl:
      return format_stl(mesh);
    case MeshFormat::off:
      break;
  }
  return format_off(mesh);
}

std::string format_textured_obj(const TriMesh& mesh, std::span<const Vec2> texture) {
  check_writable(mesh, MeshFormat::obj);
  for (std::size_t i = 0; i < texture.size(); ++i) {
    if (std::isfinite(texture[i].x) && std::isfinite(texture[i].y)) continue;
    throw Error(ErrorCode::non_finite_coordinate,
                "the texture coordinate of vertex " + std::to_string(i) + " is not finite",
                {.path = {}, .first = i});
  }
  return format_obj(mesh, texture);
}

void write_mesh(const std::filesystem::path& path, const TriMesh& mesh) {
  const std::array files = {OutputFile{path, format_mesh(mesh, mesh_format_of(path))}};
  write_files(files);
}

}  // namespace planish
