#include "draw/pdf/pdf_text.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include "draw/hex.h"
#include "draw/text/stroke_text.h"
#include "draw/text/utf8.h"

namespace planish {

namespace {

// What Windows-1252 has from 0x80 to 0x9F; 0 where it has nothing.
constexpr std::array<char32_t, 32> k_from_80 = {
    U'€', 0,    U'‚', U'ƒ', U'„', U'…', U'†', U'‡', U'ˆ', U'‰', U'Š', U'‹', U'Œ', 0, U'Ž', 0,
    0,    U'‘', U'’', U'“', U'”', U'•', U'–', U'—', U'˜', U'™', U'š', U'›', U'œ', 0, U'ž', U'Ÿ'};

// Advances of Helvetica's glyphs from ' ' to '~', in thousandths, as its metrics tell.
constexpr std::array<std::uint16_t, 95> k_widths = {
    278, 278, 355, 556, 556, 889, 667, 191, 333, 333, 389, 584, 278, 333,  278, 278, 556, 556, 556,
    556, 556, 556, 556, 556, 556, 556, 278, 278, 584, 584, 584, 556, 1015, 667, 667, 722, 722, 667,
    611, 778, 722, 278, 500, 667, 556, 833, 722, 778, 667, 778, 722, 667,  611, 722, 667, 944, 667,
    667, 611, 278, 278, 278, 469, 556, 333, 556, 556, 500, 556, 556, 278,  556, 556, 222, 222, 500,
    222, 833, 556, 556, 556, 556, 333, 500, 278, 556, 500, 722, 500, 500,  500, 334, 260, 334, 584};

constexpr char32_t k_minus = 0x2212, k_en_dash = 0x2013;

std::optional<char> win_ansi_byte(char32_t point) {
  if (point == k_minus) point = k_en_dash;
  if (point == U'\t' || point == U'\n' || point == U'\r') point = U' ';
  const bool is_same = (point >= 0x20 && point < 0x7F) || (point >= 0xA0 && point <= 0xFF);
  if (is_same) return static_cast<char>(point);
  const auto* const found = std::find(k_from_80.begin(), k_from_80.end(), point);
  if (point == 0 || found == k_from_80.end()) return std::nullopt;
  return static_cast<char>(0x80 + (found - k_from_80.begin()));
}

// Of a byte beyond ASCII: accents do not widen a letter.
double width_beyond_ascii(unsigned char byte) {
  constexpr std::string_view letters =
      "AAAAAA@CEEEEIIIIDNOOOOO+OUUUUYPoaaaaaa%ceeee    onooooo+ouuuuypy";  // from 0xC0 on
  constexpr double wide = 1000.0;  // ellipsis, em dash, ligatures and the like
  if (byte == 0x85 || byte == 0x89 || byte == 0x8C || byte == 0x97 || byte == 0x99) return wide;
  if (byte == 0xB0) return 400.0;                  // degree
  if (byte == 0xB1 || byte == 0xAC) return 584.0;  // plus-minus, not
  if (byte < 0xC0) return 556.0;
  return k_widths[static_cast<std::size_t>(letters[byte - 0xC0] - ' ')];
}

}  // namespace

std::optional<std::string> win_ansi(std::string_view utf8) {
  std::string bytes;
  bytes.reserve(utf8.size());
  for (const char32_t point : code_points(utf8)) {
    const auto byte = win_ansi_byte(point);
    if (!byte) return std::nullopt;
    bytes += *byte;
  }
  return bytes;
}

std::string in_pdf_letters(std::string_view utf8) {
  return win_ansi(utf8) ? std::string(utf8) : in_stroke_letters(utf8);
}

double helvetica_width(std::string_view win_ansi) {
  double width = 0.0;
  for (const char c : win_ansi) {
    const auto byte = static_cast<unsigned char>(c);
    width += byte < 0x7F ? k_widths[byte - 0x20U] : width_beyond_ascii(byte);
  }
  return width / 1000.0;
}

std::string pdf_string(std::string_view bytes) {
  std::string text = "(";
  for (const char c : bytes) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '(' || c == ')' || c == '\\') {
      text += '\\';
      text += c;
    } else if (byte >= 0x20 && byte < 0x7F) {
      text += c;
    } else {
      text += '\\';
      for (const int shift : {6, 3, 0})
        text += static_cast<char>('0' + ((byte >> shift) & 7));
    }
  }
  return text + ')';
}

std::string pdf_unicode_string(std::string_view utf8) {
  std::string text = "<FEFF";
  for (const char32_t point : code_points(utf8)) {
    for (const char16_t unit : utf16_units(point))
      append_hex(text, unit, 4);
  }
  return text + '>';
}

}  // namespace planish
