#include "platform/path.h"

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

}  // namespace planish
