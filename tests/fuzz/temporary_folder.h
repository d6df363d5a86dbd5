#pragma once

// A folder of the process's own, in which targets that need files work.

#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <string_view>

#include <unistd.h>

namespace planish::fuzz {

/// Empty, the current one, and gone at the end of the process.
class TemporaryFolder {
 public:
  TemporaryFolder()
      : path_(std::filesystem::temp_directory_path() /
              ("planish_fuzz_" + std::to_string(getpid()))) {
    std::filesystem::remove_all(path_);
    std::filesystem::create_directories(path_ / "work");
    std::filesystem::current_path(path_ / "work");
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::current_path(path_.parent_path(), ignored);
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  /// Removes all that is in it and writes these files.
  void fill(const std::map<std::string, std::string>& files) const {
    for (const auto& entry : std::filesystem::directory_iterator(path_ / "work"))
      std::filesystem::remove_all(entry);
    for (const auto& [name, content] : files)
      std::ofstream(path_ / "work" / name, std::ios::binary) << content;
  }

  /// Whether nothing came to lie beside it.
  bool is_alone() const {
    std::size_t entries = 0;
    for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(path_))
      ++entries;
    return entries == 1;
  }

 private:
  std::filesystem::path path_;
};

/// The names of all that is in the current folder, at any depth, each with its size.
inline std::map<std::string, std::uintmax_t> files_here() {
  std::map<std::string, std::uintmax_t> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator("."))
    files[entry.path().string()] = entry.is_regular_file() ? entry.file_size() : 0;
  return files;
}

}  // namespace planish::fuzz
