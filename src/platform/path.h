#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace planish {

/// The path that a text names. All text of the library is UTF-8: names of files in errors, options
/// and what the command line says. std::filesystem::path takes a std::string for text in the
/// encoding of the system, which on Windows is another one; so every conversion goes through here.
/// Where names are bytes, as on Linux, any text is taken as it is.
std::filesystem::path path_of(std::string_view utf8);

/// The text of a path: utf8_of(path_of(text)) is the text. On Windows folders come out with a slash
/// between them, whatever they went in with, and what is no UTF-8 comes out as U+FFFD.
std::string utf8_of(const std::filesystem::path& path);

/// The first letter of a path that no name can have on this system; 0 where there is none.
char forbidden_letter(const std::filesystem::path& path);

/// The paths in a folder, in no order; where it cannot be read those that were found until then.
/// @param failure why it cannot
/// Unlike GCC's std::filesystem::directory_iterator it does not end the program on POSIX systems
/// where memory runs out.
std::vector<std::filesystem::path> entries_of(const std::filesystem::path& folder,
                                              std::error_code& failure);

/// Whether the system would let this user make files in a folder. True where only trying shows it,
/// as on Windows.
bool may_write_into(const std::filesystem::path& folder);

}  // namespace planish
