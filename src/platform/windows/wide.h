#pragma once

#include <string>
#include <string_view>

namespace planish {

/// Text as the system takes it, in UTF-16. Bytes that are no UTF-8 become U+FFFD: no file has that
/// name, so the error shows it.
std::wstring wide_of(std::string_view utf8);

/// Text of the system in UTF-8. Halves of surrogate pairs become U+FFFD.
std::string utf8_of_wide(std::wstring_view wide);

}  // namespace planish
