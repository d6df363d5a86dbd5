#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include <planish_json/json.h>

namespace planish::cli {

// What an earlier run wrote, for --resume: anybody may have written there since.

/// The bytes of a regular file; nothing where there is none.
std::optional<std::string> kept_content(const std::filesystem::path& path);

/// The object that a file holds in JSON; null where it holds nothing of the kind.
Json kept_json(const std::filesystem::path& path);

/// A short hash of content, to see whether it changed.
std::string content_hash(std::string_view bytes);

/// Whether every file is there as it was written.
/// @param files name in the folder or in one below -> content_hash(); none are not as written
bool are_as_written(const Json& files, const std::filesystem::path& folder);

/// The hashes of all files in a folder and below, by their names there.
Json hashes_of_files(const std::filesystem::path& folder);

}  // namespace planish::cli
