#include "platform/path.h"

namespace planish {

std::filesystem::path path_of(std::string_view utf8) {
  return utf8;
}

std::string utf8_of(const std::filesystem::path& path) {
  return path.native();
}

}  // namespace planish
