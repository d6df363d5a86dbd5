#pragma once

#include <filesystem>
#include <span>
#include <string>

namespace planish {

/// A file to be written.
struct OutputFile {
  std::filesystem::path path;  ///< missing folders are made
  std::string content;         ///< bytes
};

/// Writes all files or none: each goes beside its place under a passing name, and all are renamed
/// only when every one is complete. Folders that are missing are made. Existing files are replaced.
/// A symbolic link is followed, since the caller named it: what it points to is replaced. Not so
/// below `folder`: there a link in a file's place is replaced itself, and a link, pipe or device
/// in the way is an error, so that nothing is written outside of the folder.
/// @param folder that is written into; empty where the caller named each file
/// @throws Error file_unwritable naming the path and the cause; nothing is left behind then
void write_files(std::span<const OutputFile> files, const std::filesystem::path& folder = {});

}  // namespace planish
