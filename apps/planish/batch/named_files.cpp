#include "batch/named_files.h"

#include <set>

#include "platform/path.h"
#include "product/parts.h"
#include "shell/failures.h"
#include "shell/file_name.h"
#include "shell/safe_names.h"

namespace planish::cli {

namespace {

namespace fs = std::filesystem;

fs::path place_of(const fs::path& path) {
  std::error_code ignored;
  const fs::path whole = fs::weakly_canonical(path, ignored);
  return whole.empty() ? fs::absolute(path).lexically_normal() : whole;
}

}  // namespace

bool is_folder(const std::string& path) {
  std::error_code ignored;
  return fs::is_directory(path_of(path), ignored);
}

std::vector<WorkFile> files_named(const std::vector<std::string>& operands, Session& session) {
  std::vector<WorkFile> files;
  const auto add = [&](const std::string& path) -> FileReport& {
    WorkFile& file = files.emplace_back();
    file.report.path = path;
    return file.report;
  };
  for (const std::string& operand : operands) {
    if (!is_folder(operand)) {
      add(operand);
      continue;
    }
    try {
      for (const std::string& path : mesh_files_in(session, operand))
        add(path);
    } catch (const Error&) {
      add(operand).failure = current_failure();
    }
  }
  return files;
}

std::vector<fs::path> output_places(
    std::span<const WorkFile> files, const fs::path& folder,
    const std::function<std::string(const std::string&)>& extension) {
  std::set<fs::path> inputs;
  std::vector<std::string> stems;
  for (const WorkFile& file : files) {
    inputs.insert(place_of(path_of(file.report.path)));
    stems.push_back(stem_of(file.report.path));
  }
  const std::vector<std::string> names = safe_names(stems);
  std::vector<fs::path> places;
  for (std::size_t f = 0; f < files.size(); ++f) {
    places.push_back(folder / path_of(names[f] + extension(files[f].report.path)));
    if (inputs.contains(place_of(places.back()))) {
      throw UsageError("output " + utf8_of(places.back()) +
                       " would replace an input: take another folder for --output");
    }
  }
  return places;
}

std::string short_path(const std::string& path, std::size_t width) {
  if (path.size() <= width) return path;
  std::size_t from = path.size() - width + 1;
  while (from < path.size() && (static_cast<unsigned char>(path[from]) & 0xC0U) == 0x80U)
    ++from;
  return "~" + path.substr(from);
}

}  // namespace planish::cli
