#include "shell/safe_names.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "mesh/split.h"
#include "shell/file_name.h"
#include "shell/text.h"

namespace planish::cli {

namespace {

bool is_plain(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
         c == '_' || c == '.';
}

/// Shows nothing, or turns what stands around it: a name could look like another one.
bool is_invisible(char32_t c) {
  return c < 0xA0 || (c >= 0x200B && c <= 0x200F) || (c >= 0x2028 && c <= 0x202E) ||
         (c >= 0x2060 && c <= 0x206F) || c == 0xFEFF || c == 0xAD || c == 0x61C;
}

/// Length of the letter beyond ASCII that begins there; 0 where there is none, or none to be seen.
std::size_t letter_length(std::string_view text) {
  const auto lead = static_cast<unsigned char>(text[0]);
  const std::size_t length = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
  if (lead < 0xC2 || lead > 0xF4 || text.size() < length) return 0;
  char32_t value = lead & (0xFFU >> (length + 1));
  for (const char c : text.substr(1, length - 1)) {
    const auto byte = static_cast<unsigned char>(c);
    if ((byte & 0xC0U) != 0x80U) return 0;
    value = value << 6U | (byte & 0x3FU);
  }
  constexpr std::array<char32_t, 5> smallest = {0, 0, 0x80, 0x800, 0x10000};
  const bool is_letter = value >= smallest.at(length) && value <= 0x10FFFF &&
                         (value < 0xD800 || value > 0xDFFF) && !is_invisible(value);
  return is_letter ? length : 0;
}

std::string in_small_letters(std::string name) {
  for (char& c : name) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return name;
}

/// Windows takes these, whatever follows a dot, for devices.
bool is_device(const std::string& name) {
  const std::string stem = in_small_letters(name.substr(0, name.find('.')));
  if (stem == "con" || stem == "prn" || stem == "aux" || stem == "nul") return true;
  const std::string kind = stem.substr(0, 3);
  return stem.size() == 4 && (kind == "com" || kind == "lpt") && stem[3] >= '0' && stem[3] <= '9';
}

/// Whether a file beside the folders of patches could have the name: garment.json, layout-1.svg.
bool is_like_a_file(const std::string& name) {
  const std::string extension = lower_extension(name);
  constexpr std::array kinds = {".json", ".html", ".svg", ".dxf", ".pdf", ".plt"};
  return std::find(kinds.begin(), kinds.end(), extension) != kinds.end();
}

std::string safe_name(const std::string& name) {
  constexpr std::size_t k_longest_name = 80;
  std::string safe;
  safe.reserve(name.size());
  for (std::size_t i = 0; i < name.size();) {
    const std::size_t length =
        is_plain(name[i]) ? 1 : letter_length(std::string_view(name).substr(i));
    safe += length > 0 ? name.substr(i, length) : "_";
    i += std::max<std::size_t>(1, length);
  }
  safe = beginning(safe, k_longest_name);
  while (!safe.empty() && safe.back() == '.')
    safe.pop_back();  // Windows drops them
  if (!safe.empty() && (safe.front() == '.' || safe.front() == '-')) safe.front() = '_';
  if (safe.empty()) safe = "patch";
  return is_device(safe) || is_like_a_file(safe) ? safe + "_" : safe;
}

}  // namespace

std::vector<std::string> safe_names(const std::vector<std::string>& names) {
  std::vector<std::string> safe(names.size());
  std::transform(names.begin(), names.end(), safe.begin(), safe_name);
  return distinct_names(safe);
}

}  // namespace planish::cli
