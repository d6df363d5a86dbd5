#include "platform/path.h"

#include <cerrno>
#include <memory>

#include <dirent.h>
#include <unistd.h>

namespace planish {

std::filesystem::path path_of(std::string_view utf8) {
  return utf8;
}

std::string utf8_of(const std::filesystem::path& path) {
  return path.native();
}

char forbidden_letter(const std::filesystem::path&) {
  return 0;
}

bool may_write_into(const std::filesystem::path& folder) {
  return access(folder.c_str(), W_OK | X_OK) == 0;
}

std::vector<std::filesystem::path> entries_of(const std::filesystem::path& folder,
                                              std::error_code& failure) {
  std::vector<std::filesystem::path> entries;
  failure.clear();
  const std::unique_ptr<DIR, int (*)(DIR*)> open(opendir(folder.c_str()), &closedir);
  if (!open) {
    failure = {errno, std::generic_category()};
    return entries;
  }
  errno = 0;
  while (const dirent* entry = readdir(open.get())) {
    const std::string_view name = entry->d_name;
    if (name != "." && name != "..") entries.push_back(folder / name);
    errno = 0;
  }
  if (errno != 0) failure = {errno, std::generic_category()};
  return entries;
}

}  // namespace planish
