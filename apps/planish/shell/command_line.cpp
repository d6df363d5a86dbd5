#include "shell/command_line.h"

#include <algorithm>
#include <array>

namespace planish::cli {

namespace {

/// As a shell takes it for one word.
std::string word(const std::string& text) {
  constexpr std::string_view plain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=:,./%@";
  if (!text.empty() && text.find_first_not_of(plain) == std::string::npos) return text;
  return in_quotes(text);
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

std::string command_line(std::string_view verb, const Arguments& arguments) {
  constexpr std::array<std::string_view, 5> silent = {"--json", "--quiet", "--open", "--resume",
                                                      "--threads"};
  std::string line = "planish " + std::string(verb);
  for (const std::string& operand : arguments.operands)
    line += " " + word(operand);
  for (const auto& [flag, value] : arguments.flags) {
    if (std::find(silent.begin(), silent.end(), flag) != silent.end()) continue;
    line += " " + flag;
    if (!value.empty()) line += " " + word(value);
  }
  return line;
}

}  // namespace planish::cli
