#include <planish/core/error.h>
#include <planish/io/read_mesh.h>

#include "io/file/file_bytes.h"
#include "io/file/foreign_file.h"
#include "io/formats/formats.h"
#include "platform/path.h"

namespace planish {

ReadResult read_mesh(const std::filesystem::path& path) {
  const MeshFormat format = readable_format_of(path);
  const FileBytes file(path);
  return parse_mesh(file.view(), format, utf8_of(path));
}

ReadResult parse_mesh(std::string_view bytes, MeshFormat format, const std::string& name) {
  if (bytes.empty()) throw Error(ErrorCode::no_triangles, "the file is empty", {.path = name});
  // The header of a binary STL file may begin with anything.
  if (format != MeshFormat::stl) refuse_foreign(bytes, name);
  switch (format) {
    case MeshFormat::obj:
      return parse_obj(bytes, name);
    case MeshFormat::ply:
      return parse_ply(bytes, name);
    case MeshFormat::stl:
      return parse_stl(bytes, name);
    case MeshFormat::off:
      break;
  }
  return parse_off(bytes, name);
}

}  // namespace planish
