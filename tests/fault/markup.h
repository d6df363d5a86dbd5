#pragma once

#include <cctype>
#include <set>
#include <string>
#include <string_view>
#include <vector>

// A plain reader of SVG and HTML: which tags there are, with which attributes.

namespace planish::fault {

struct Markup {
  std::set<std::string> tags;  ///< "name", and "name attribute" for each attribute
  std::string fault;           ///< empty where it is well-formed
};

/// @param is_xml then every tag has an end and text has no control characters
inline Markup markup_of(std::string_view text, bool is_xml) {
  Markup found;
  std::vector<std::string> open;
  const auto is_name = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == ':' || c == '_';
  };
  std::size_t i = 0, scripts = 0;
  const auto word = [&] {
    const std::size_t begin = i;
    while (i < text.size() && is_name(text[i]))
      ++i;
    return std::string(text.substr(begin, i - begin));
  };
  while (i < text.size()) {
    if (is_xml && static_cast<unsigned char>(text[i]) < 0x20 && text[i] != '\n') {
      found.fault = "a control character";
    }
    if (text[i] == '&') {
      const std::size_t end = text.find(';', i);
      if (end == std::string_view::npos || end > i + 8) found.fault = "a bare ampersand";
    }
    if (text[i++] != '<') continue;
    if (text[i] == '?' || text[i] == '!') {
      i = text.find('>', i);
      continue;
    }
    const bool ends = text[i] == '/';
    if (ends) ++i;
    const std::string name = word();
    if (name.empty()) found.fault = "a bare <";
    found.tags.insert(name);
    bool closed = false;
    while (i < text.size() && text[i] != '>') {
      closed = text[i] == '/';
      if (!is_name(text[i])) {
        ++i;
        continue;
      }
      const std::string attribute = word();
      found.tags.insert(name + " " + attribute);
      if (text[i] != '=') continue;
      const char quote = text[++i];
      if (quote != '"' && quote != '\'') {
        found.fault = "a value without quotes";
        continue;
      }
      const std::size_t end = text.find(quote, i + 1);
      if (end == std::string_view::npos) return {found.tags, "an open quote"};
      if (text.substr(i, end - i).find('<') != std::string_view::npos) found.fault = "< in a value";
      i = end + 1;
    }
    if (!is_xml && !ends && name == "script") {
      // Not markup up to its end. Counted: one more than there should be is found.
      found.tags.insert("script number " + std::to_string(++scripts));
      i = text.find("</script", i);
      if (i == std::string_view::npos) return {found.tags, "a script without an end"};
    }
    if (!is_xml || closed) continue;
    if (!ends) {
      open.push_back(name);
    } else if (open.empty() || open.back() != name) {
      found.fault = "</" + name + "> without a beginning";
    } else {
      open.pop_back();
    }
  }
  if (!open.empty()) found.fault = "<" + open.back() + "> without an end";
  return found;
}

}  // namespace planish::fault
