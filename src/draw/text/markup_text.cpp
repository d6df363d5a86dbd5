#include "draw/text/markup_text.h"

#include <cstddef>

#include "draw/text/utf8.h"

namespace planish {

namespace {

constexpr std::string_view k_replacement = "\xEF\xBF\xBD";

bool is_forbidden(char32_t value) {
  return value < 0x20 || (value >= 0x7F && value < 0xA0) || (value & 0xFFFE) == 0xFFFE;
}

}  // namespace

std::string escape_markup(std::string_view text) {
  std::string escaped;
  escaped.reserve(text.size());
  while (!text.empty()) {
    const CodePoint point = decode_utf8(text);
    const std::size_t bytes = point.bytes > 0 ? point.bytes : 1;
    switch (point.bytes > 0 ? point.value : U'\0') {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      case '\'':
        escaped += "&#39;";
        break;
      case '\t':
      case '\n':
      case '\r':
        escaped += ' ';
        break;
      default:
        if (point.bytes == 0 || is_forbidden(point.value)) {
          escaped += k_replacement;
        } else {
          escaped += text.substr(0, bytes);
        }
    }
    text.remove_prefix(bytes);
  }
  return escaped;
}

}  // namespace planish
