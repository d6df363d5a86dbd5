#include "io/file/cursor_error.h"

namespace planish {

void throw_read_error(ErrorCode code, const std::string& message, SourceLocation place,
                      ReadItem item) {
  if (item.kind.empty()) throw Error(code, message, std::move(place));
  place.first = item.number;
  throw Error(code, printable(item.kind) + " " + std::to_string(item.number) + ": " + message,
              std::move(place));
}

std::string in_quotes(std::string_view text) {
  return '"' + printable(text) + '"';
}

std::string printable(std::string_view text) {
  constexpr std::size_t k_longest = 40;
  constexpr std::string_view k_digits = "0123456789abcdef";
  std::string out;
  for (const char c : text.substr(0, k_longest)) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x20 && byte < 0x7f) {
      out += c;
    } else {
      out += {'\\', 'x', k_digits[byte >> 4], k_digits[byte & 15]};
    }
  }
  return text.size() > k_longest ? out + "..." : out;
}

}  // namespace planish
