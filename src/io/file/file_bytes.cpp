#include "io/file/file_bytes.h"

#include <planish/core/error.h>

#include "platform/path.h"

namespace planish {

FileBytes::FileBytes(const std::filesystem::path& path) : content_(path) {
  if (content_.is_device()) {
    throw Error(ErrorCode::file_unreadable, "is a device", {.path = utf8_of(path)});
  }
  const std::error_code fault = content_.fault();
  if (!fault) return;
  const bool missing =
      fault == std::errc::no_such_file_or_directory || fault == std::errc::not_a_directory;
  throw Error(missing ? ErrorCode::file_not_found : ErrorCode::file_unreadable,
              "cannot be read: " + fault.message(), {.path = utf8_of(path)});
}

}  // namespace planish
