#include "output/kept_files.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <system_error>
#include <vector>

#include "core/fnv_hash.h"
#include "platform/path.h"

namespace planish::cli {

namespace {

namespace fs = std::filesystem;

/// Whether a name leads to a place in the folder that it begins in.
bool stays_inside(const fs::path& name) {
  return !name.empty() && name.is_relative() && !name.has_root_path() &&
         std::none_of(name.begin(), name.end(),
                      [](const fs::path& part) { return part == ".." || part == "."; });
}

void add_hashes(const fs::path& folder, const std::string& before, Json& hashes) {
  std::error_code failure;
  std::vector<fs::path> entries = entries_of(folder, failure);
  std::sort(entries.begin(), entries.end());
  for (const fs::path& entry : entries) {
    const std::string name = before + utf8_of(entry.filename());
    std::error_code none;
    if (fs::is_directory(fs::symlink_status(entry, none))) add_hashes(entry, name + "/", hashes);
    if (const auto content = kept_content(entry)) hashes[name] = content_hash(*content);
  }
}

}  // namespace

std::optional<std::string> kept_content(const fs::path& path) {
  std::error_code none;
  // What stands there may be anybody's: nothing that has no end or is elsewhere.
  if (!fs::is_regular_file(fs::symlink_status(path, none))) return std::nullopt;
  std::ifstream file(path, std::ios::binary);
  if (!file) return std::nullopt;
  std::string content{std::istreambuf_iterator<char>(file), {}};
  return file.bad() ? std::nullopt : std::optional(std::move(content));
}

Json kept_json(const fs::path& path) {
  const auto content = kept_content(path);
  Json json = content ? parse_shallow(*content) : Json(nullptr);
  return json.is_object() ? json : Json(nullptr);
}

std::string content_hash(std::string_view bytes) {
  FnvHash hash;
  hash.add(bytes);
  return hash_text(hash.value());
}

bool are_as_written(const Json& files, const fs::path& folder) {
  if (!files.is_object() || files.empty()) return false;
  return std::all_of(files.items().begin(), files.items().end(), [&](const auto& item) {
    const fs::path file = path_of(item.key());
    if (!stays_inside(file)) return false;
    const auto content = kept_content(folder / file);
    return content && item.value().is_string() && item.value() == content_hash(*content);
  });
}

Json hashes_of_files(const fs::path& folder) {
  Json hashes = Json::object();
  add_hashes(folder, {}, hashes);
  return hashes;
}

}  // namespace planish::cli
