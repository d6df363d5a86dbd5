#pragma once

#include <filesystem>
#include <span>
#include <string>

namespace planish {

struct OutputFile {
  std::filesystem::path path;
  std::string content;
};

/// Writes all files or none: each goes beside its place under a passing name, and all are renamed
/// only when every one is complete. Folders that are missing are made. Existing files are replaced.
/// @throws Error file_unwritable naming the path and the cause; nothing is left behind then
void write_files(std::span<const OutputFile> files);

}  // namespace planish
