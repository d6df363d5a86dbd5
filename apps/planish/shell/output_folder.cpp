#include "shell/output_folder.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <system_error>

#include <planish/core/error.h>

#include "platform/path.h"
#include "shell/failures.h"
#include "shell/file_name.h"

namespace planish::cli {

namespace {

/// Of drawings, one of which is what such a name asks for.
constexpr std::array<std::string_view, 4> k_extensions = {".svg", ".dxf", ".pdf", ".plt"};

bool is_like_a_drawing(const std::string& name) {
  return std::find(k_extensions.begin(), k_extensions.end(), lower_extension(name)) !=
         k_extensions.end();
}

/// On Windows a folder in quotes that ends with a backslash is the likeliest cause.
void refuse_forbidden_letter(const std::filesystem::path& path, const std::string& folder) {
  const char letter = forbidden_letter(path);
  if (letter == 0) return;
  if (letter == '*' || letter == '?') {
    throw UsageError(folder + " has the sign " + letter +
                     ", which no name can have: Windows does not put the names of files for it, so "
                     "name a folder, or each file");
  }
  const std::string hint =
      letter == '"' ? "; behind a name in quotes there must be no backslash: \"out\", not \"out\\\""
                    : "";
  throw UsageError("--output is " + folder + ", but no name can have the sign " + letter + hint);
}

/// Refuses before the work what could not be written after it. Where it cannot be known, as for
/// folders that others share on a network, writing will say so.
void refuse_closed_folder(std::filesystem::path path, const std::string& folder) {
  std::error_code ignored;
  path = std::filesystem::absolute(path, ignored);
  while (path.has_relative_path() && !std::filesystem::exists(path, ignored))
    path = path.parent_path();
  if (!std::filesystem::is_directory(path, ignored) || may_write_into(path)) return;
  throw Error(ErrorCode::file_unwritable,
              "cannot be written: Permission denied for the folder " + utf8_of(path),
              {.path = folder});
}

}  // namespace

std::filesystem::path output_folder(const std::string& folder) {
  std::filesystem::path path = path_of(folder);
  refuse_forbidden_letter(path, folder);
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) {
    refuse_closed_folder(path, folder);
    return path;
  }
  if (std::filesystem::exists(path, ignored)) {
    throw Error(ErrorCode::file_unwritable, "is a file, but a folder is to be written there",
                {.path = folder});
  }
  if (is_like_a_drawing(folder)) {
    const std::string stem = folder.substr(0, folder.rfind('.'));
    throw UsageError("--output is \"" + folder + "\" but names a folder for several files: use \"" +
                     stem + "\"");
  }
  refuse_closed_folder(path, folder);
  return path;
}

MeshFormat output_format(MeshFormat input) {
  return input == MeshFormat::stl ? MeshFormat::obj : input;
}

}  // namespace planish::cli
