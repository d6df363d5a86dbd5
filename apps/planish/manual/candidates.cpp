#include "manual/candidates.h"

#include <algorithm>

namespace planish::cli {

namespace {

Candidates candidates_of(ValueType type, const FlagValue& value) {
  using Kind = Candidates::Kind;
  switch (type) {
    case ValueType::file:
      return {Kind::file, value.extensions};
    case ValueType::folder:
      return {Kind::folder};
    case ValueType::names:
      return {Kind::some, value.choices};
    default:
      // Some numbers may be a word too.
      return {value.choices.empty() ? Kind::nothing : Kind::one, value.choices};
  }
}

}  // namespace

Candidates candidates_of(const Flag& flag) {
  return candidates_of(type_of(flag), flag.accepts);
}

Candidates candidates_of(const FlagValue& operand) {
  return candidates_of(type_of(operand), operand);
}

std::vector<Flag> distinct_flags(const std::vector<FlagGroup>& groups) {
  std::vector<Flag> flags;
  for (const FlagGroup& group : groups) {
    for (const Flag& flag : group.flags) {
      const auto same = std::find_if(flags.begin(), flags.end(),
                                     [&](const Flag& other) { return other.name == flag.name; });
      if (same == flags.end()) {
        flags.push_back(flag);
        continue;
      }
      std::vector<std::string>& choices = same->accepts.choices;
      for (const std::string& choice : flag.accepts.choices) {
        if (std::find(choices.begin(), choices.end(), choice) == choices.end())
          choices.push_back(choice);
      }
    }
  }
  return flags;
}

std::vector<std::string> offered_names(const Flag& flag) {
  std::vector<std::string> names = {flag.name};
  if (flag.letter != 0) names.push_back(std::string("-") + flag.letter);
  return names;
}

std::string short_doc(const Flag& flag) {
  return flag.doc.substr(0, flag.doc.find(" ("));
}

std::string joined(const std::vector<std::string>& words, std::string_view separator) {
  std::string text;
  for (const std::string& word : words) {
    if (!text.empty()) text += separator;
    text += word;
  }
  return text;
}

std::string escaped(std::string_view text, std::string_view characters) {
  std::string result;
  for (const char c : text) {
    if (characters.find(c) != std::string_view::npos) result += '\\';
    result += c;
  }
  return result;
}

}  // namespace planish::cli
