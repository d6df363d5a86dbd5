#include "shell/output_folder.h"

#include <system_error>

#include <planish/core/error.h>

#include "platform/path.h"

namespace planish::cli {

std::filesystem::path output_folder(const std::string& folder) {
  std::filesystem::path path = path_of(folder);
  std::error_code ignored;
  if (std::filesystem::exists(path, ignored) && !std::filesystem::is_directory(path, ignored)) {
    throw Error(ErrorCode::file_unwritable, "is a file, but a folder is to be written there",
                {.path = folder});
  }
  return path;
}

MeshFormat output_format(MeshFormat input) {
  return input == MeshFormat::stl ? MeshFormat::obj : input;
}

}  // namespace planish::cli
