#include "draw/text/text_lines.h"

#include <algorithm>

#include "draw/text/stroke_text.h"

namespace planish {

namespace {

std::size_t code_points_in(std::string_view text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char byte) {
    return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U;  // not inside a UTF-8 sequence
  }));
}

}  // namespace

std::size_t letters_in(std::string_view text) {
  return std::max(code_points_in(text), code_points_in(in_stroke_letters(text)));
}

std::vector<std::string> broken_lines(std::string_view text, std::size_t most_letters) {
  constexpr std::string_view dot = " · ", blank = " ";
  const std::string_view sign = text.find(dot) != std::string_view::npos ? dot : blank;
  std::vector<std::string> lines;
  while (true) {
    const std::size_t end = text.find(sign);
    const std::string part(text.substr(0, end));
    if (!lines.empty() &&
        letters_in(lines.back()) + letters_in(sign) + letters_in(part) <= most_letters) {
      lines.back() += std::string(sign) + part;
    } else {
      lines.push_back(part);
    }
    if (end == std::string_view::npos) return lines;
    text.remove_prefix(end + sign.size());
  }
}

}  // namespace planish
