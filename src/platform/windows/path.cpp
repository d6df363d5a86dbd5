#include "platform/path.h"

#include <algorithm>

#include "platform/windows/wide.h"

namespace planish {

std::filesystem::path path_of(std::string_view utf8) {
  return wide_of(utf8);
}

/// Folders are separated by slashes, as on other systems: what is printed and written into reports
/// is then the same. Windows takes them too, but for names that begin with \\?\.
std::string utf8_of(const std::filesystem::path& path) {
  std::wstring wide = path.native();
  if (!wide.starts_with(L"\\\\?\\")) std::replace(wide.begin(), wide.end(), L'\\', L'/');
  return utf8_of_wide(wide);
}

char forbidden_letter(const std::filesystem::path& path) {
  const std::wstring& wide = path.native();
  const std::size_t begin = wide.starts_with(L"\\\\?\\") ? 4 : 0;
  const std::size_t at = wide.find_first_of(L"\"<>|*?", begin);
  return at == std::wstring::npos ? 0 : static_cast<char>(wide[at]);
}

bool may_write_into(const std::filesystem::path&) {
  return true;
}

std::vector<std::filesystem::path> entries_of(const std::filesystem::path& folder,
                                              std::error_code& failure) {
  std::vector<std::filesystem::path> entries;
  for (std::filesystem::directory_iterator at(folder, failure), end; !failure && at != end;
       at.increment(failure))
    entries.push_back(at->path());
  return entries;
}

}  // namespace planish
