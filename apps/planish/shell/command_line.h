#pragma once

#include <string>
#include <string_view>

#include "shell/command.h"

namespace planish::cli {

/// The text between single quotes, as the shells of Unix take it for one word.
std::string in_quotes(std::string_view text);

/// The text as a shell takes it for one word, in quotes where it needs them: double ones where
/// these do, as the shells of Windows know no others.
std::string shell_word(std::string_view text);

/// A command line that asks for the same, for a shell: the verb, what it works on and its flags by
/// their full names, without those that change nothing of what is written.
std::string command_line(const Command& verb, const Arguments& arguments);

}  // namespace planish::cli
