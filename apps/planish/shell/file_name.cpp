#include "shell/file_name.h"

#include "platform/path.h"

namespace planish::cli {

std::string stem_of(const std::string& path) {
  return utf8_of(path_of(path).stem());
}

std::string extension_of(const std::string& path) {
  return utf8_of(path_of(path).extension());
}

std::string lower_extension(const std::string& path) {
  std::string extension = extension_of(path);
  for (char& c : extension) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return extension;
}

}  // namespace planish::cli
