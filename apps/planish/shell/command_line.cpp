#include "shell/command_line.h"

#include <algorithm>
#include <array>

namespace planish::cli {

namespace {

/// Whether shells take the text between double quotes as it is: cmd and PowerShell of Windows too.
bool is_plain_in_double_quotes(std::string_view text) {
  return text.find_first_of("\"$`!%\n") == std::string_view::npos &&
         text.find("\\\\") == std::string_view::npos && !text.ends_with('\\');
}

}  // namespace

std::string in_quotes(std::string_view text) {
  std::string quoted = "'";
  for (const char c : text) {
    if (c == '\'') {
      quoted += "'\\''";
    } else {
      quoted += c;
    }
  }
  return quoted + "'";
}

std::string shell_word(std::string_view text) {
  constexpr std::string_view plain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=:,./%@";
  if (!text.empty() && text.find_first_not_of(plain) == std::string_view::npos)
    return std::string(text);
  if (!text.empty() && is_plain_in_double_quotes(text)) return '"' + std::string(text) + '"';
  return in_quotes(text);
}

std::string command_line(const Command& verb, const Arguments& arguments) {
  constexpr std::array<std::string_view, 5> silent = {"--json", "--quiet", "--open", "--resume",
                                                      "--threads"};
  std::string line = "planish " + verb.name;
  for (const std::string& operand : arguments.operands)
    line += " " + shell_word(operand);
  for (const auto& [flag, value] : arguments.flags) {
    if (std::find(silent.begin(), silent.end(), flag) != silent.end()) continue;
    line += " " + flag;
    const std::string word = arguments.text(flag);
    if (word.empty()) continue;
    const Flag* const found = find_flag(verb, flag);
    line += (found != nullptr && found->accepts.optional ? "=" : " ") + shell_word(word);
  }
  return line;
}

}  // namespace planish::cli
