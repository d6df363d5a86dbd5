#include <string>

#include <planish/core/error.h>
#include <planish/io/mesh_format.h>

#include "io/file/cursor_error.h"
#include "io/formats/formats.h"
#include "platform/path.h"

namespace planish {

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

}  // namespace planish
