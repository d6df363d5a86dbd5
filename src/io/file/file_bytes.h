#pragma once

#include <filesystem>
#include <string_view>

#include "platform/file.h"

namespace planish {

/// The bytes of a file for as long as the object lives.
class FileBytes {
 public:
  /// @throws Error file_not_found, file_unreadable
  explicit FileBytes(const std::filesystem::path& path);

  std::string_view view() const { return content_.bytes(); }

 private:
  FileContent content_;
};

}  // namespace planish
