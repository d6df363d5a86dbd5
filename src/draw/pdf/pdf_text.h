#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace planish {

/// Height of Helvetica's capitals over the size of its body.
inline constexpr double k_helvetica_capital = 0.718;

/// A text in Windows-1252, which PDF calls WinAnsi; nothing where it has other characters.
std::optional<std::string> win_ansi(std::string_view utf8);

/// The text as PDF files have it: in Windows-1252 where that can hold it, else in_stroke_letters().
std::string in_pdf_letters(std::string_view utf8);

/// The width of a text in Helvetica, of size 1.
double helvetica_width(std::string_view win_ansi);

/// A string of a content stream: "(...)".
std::string pdf_string(std::string_view bytes);

/// A string that people read: "<FEFF...>".
std::string pdf_unicode_string(std::string_view utf8);

}  // namespace planish
