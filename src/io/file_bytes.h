#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace planish {

/// The bytes of a file for as long as the object lives: mapped if it is a regular file, read if it
/// is a pipe.
class FileBytes {
 public:
  /// @throws Error file_not_found, file_unreadable
  explicit FileBytes(const std::filesystem::path& path);
  ~FileBytes();
  FileBytes(const FileBytes&) = delete;
  FileBytes& operator=(const FileBytes&) = delete;

  std::string_view view() const {
    return map_ == nullptr ? std::string_view(read_)
                           : std::string_view(static_cast<const char*>(map_), map_size_);
  }

 private:
  void* map_ = nullptr;
  std::size_t map_size_ = 0;
  std::string read_;
};

}  // namespace planish
