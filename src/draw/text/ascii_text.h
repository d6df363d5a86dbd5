#pragma once

#include <string>
#include <string_view>

namespace planish {

/// A text in printable ASCII, for formats and programs without other letters. Latin letters lose
/// their accents, Greek and Cyrillic ones become Latin ones of like sound, usual signs are written
/// out; any other character becomes "u" and its number in hexadecimal digits, so that different
/// names stay different. Control characters become blanks.
std::string ascii_text(std::string_view text);

/// The same of one character.
std::string ascii_letters(char32_t point);

}  // namespace planish
