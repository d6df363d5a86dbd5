#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include <planish/core/error.h>

namespace planish {

/// What a reader is at, so that its errors can say so: "vertex 7: ...".
struct ReadItem {
  std::string_view kind = {};
  std::size_t number = 0;  ///< from 0
};

/// Where in a file something is that is looked at once all is read.
struct ReadPlace {
  std::size_t at = 0;  ///< the line of a text, from 1, or the byte, from 0
  ReadItem item = {};
};

/// Throws the error with the item in its message and its place.
[[noreturn]] void throw_read_error(ErrorCode code, const std::string& message, SourceLocation place,
                                   ReadItem item);

/// Words of a file as they may stand in a message: cut, and with \xNN for what is not printable
/// ASCII.
std::string printable(std::string_view text);
std::string in_quotes(std::string_view text);

}  // namespace planish
