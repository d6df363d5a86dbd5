#include "output_folder.h"

#include <system_error>

#include <planish/core/error.h>

namespace planish::cli {

std::filesystem::path output_folder(std::filesystem::path folder) {
  std::error_code ignored;
  if (std::filesystem::exists(folder, ignored) && !std::filesystem::is_directory(folder, ignored)) {
    throw Error(ErrorCode::file_unwritable, "is a file, but a folder is to be written there",
                {.path = folder.string()});
  }
  return folder;
}

MeshFormat output_format(MeshFormat input) {
  return input == MeshFormat::stl ? MeshFormat::obj : input;
}

}  // namespace planish::cli
