#include <iterator>
#include <utility>

#include <planish/core/error.h>
#include <planish/io/read_mesh.h>

#include "io/file/file_bytes.h"
#include "io/file/file_type_sniffer.h"
#include "io/formats/formats.h"
#include "io/unit/stated_unit.h"
#include "platform/path.h"

namespace planish {

namespace {

ReadResult parse(std::string_view bytes, MeshFormat format, const std::string& name,
                 const ReadOptions& options) {
  switch (format) {
    case MeshFormat::obj:
      return parse_obj(bytes, name, options);
    case MeshFormat::ply:
      return parse_ply(bytes, name, options);
    case MeshFormat::stl:
      return parse_stl(bytes, name, options);
    case MeshFormat::off:
      break;
  }
  return parse_off(bytes, name, options);
}

}  // namespace

ReadResult read_mesh(const std::filesystem::path& path, const ReadOptions& options) {
  const MeshFormat format = readable_format_of(path);
  const FileBytes file(path);
  return parse_mesh(file.view(), format, utf8_of(path), options);
}

std::optional<StatedUnit> read_stated_unit(const std::filesystem::path& path) {
  const MeshFormat format = readable_format_of(path);
  const FileBytes file(path);
  return find_unit(file.view(), format).unit;
}

ReadResult parse_mesh(std::string_view bytes, MeshFormat format, const std::string& name,
                      const ReadOptions& options) {
  if (bytes.empty()) throw Error(ErrorCode::no_triangles, "the file is empty", {.path = name});
  // The header of a binary STL file may begin with anything.
  if (format != MeshFormat::stl) refuse_foreign(bytes, name);
  ReadResult result = parse(bytes, format, name, options);
  UnitFinding found = find_unit(bytes, format);
  result.unit = std::move(found.unit);
  result.notes.insert(result.notes.end(), std::make_move_iterator(found.notes.begin()),
                      std::make_move_iterator(found.notes.end()));
  return result;
}

}  // namespace planish
