#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "batch/several_files.h"

namespace planish::cli {

bool is_folder(const std::string& path);

/// The files that are named, and those in folders that are; a folder that cannot be read is a file
/// that failed.
std::vector<WorkFile> files_named(const std::vector<std::string>& operands, Session& session);

/// Where the output of each file goes: into the folder, by the name of the input.
/// @throws UsageError where one would replace an input
std::vector<std::filesystem::path> output_places(
    std::span<const WorkFile> files, const std::filesystem::path& folder,
    const std::function<std::string(const std::string&)>& extension);

/// The end of a path, where files of one folder differ, in this number of columns.
std::string short_path(const std::string& path, std::size_t width);

}  // namespace planish::cli
