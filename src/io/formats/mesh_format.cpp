#include <algorithm>
#include <array>
#include <string>

#include <planish/core/error.h>
#include <planish/io/mesh_format.h>

#include "io/file/cursor_error.h"
#include "io/formats/formats.h"
#include "platform/path.h"

namespace planish {

namespace {

/// Of models that other programs write, and that no reader here reads.
constexpr std::array<std::string_view, 24> k_other_models = {
    ".glb", ".gltf", ".fbx", ".dae", ".3ds",    ".blend", ".usd",  ".usdz",
    ".3mf", ".amf",  ".wrl", ".x3d", ".step",   ".stp",   ".iges", ".igs",
    ".3dm", ".brep", ".x_t", ".sat", ".sldprt", ".ipt",   ".f3d",  ".fcstd"};

}  // namespace

std::string_view to_string(MeshFormat format) {
  switch (format) {
    case MeshFormat::obj:
      return "obj";
    case MeshFormat::ply:
      return "ply";
    case MeshFormat::stl:
      return "stl";
    case MeshFormat::off:
      break;
  }
  return "off";
}

std::string lower_extension(const std::filesystem::path& path) {
  std::string lower = utf8_of(path.extension());
  for (char& c : lower) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return lower;
}

MeshFormat mesh_format_of(const std::filesystem::path& path) {
  const std::string extension = utf8_of(path.extension());
  const std::string lower = lower_extension(path);
  for (const MeshFormat format : k_mesh_formats) {
    if (lower == "." + std::string(to_string(format))) return format;
  }
  throw Error(ErrorCode::unsupported_format,
              (extension.empty() ? "the name has no extension"
                                 : "the extension " + in_quotes(extension) + " is not known") +
                  std::string("; known are .obj, .ply, .stl and .off"),
              {.path = utf8_of(path)});
}

bool is_other_model(const std::filesystem::path& path) {
  const std::string lower = lower_extension(path);
  return std::find(k_other_models.begin(), k_other_models.end(), lower) != k_other_models.end();
}

MeshFormat readable_format_of(const std::filesystem::path& path) {
  if (!is_other_model(path)) return mesh_format_of(path);
  throw Error(ErrorCode::unsupported_format,
              "files of the kind " + in_quotes(utf8_of(path.extension())) +
                  " cannot be read; export a mesh as OBJ or STL from the program that made it",
              {.path = utf8_of(path)});
}

}  // namespace planish
