#pragma once

// Reads XML as far as our files use it, and throws where it is not well-formed.

#include <cstddef>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace planish::oracle {

struct XmlElement {
  std::string name;
  std::map<std::string, std::string> attributes;  // as written, entities not replaced
};

class XmlReader {
 public:
  explicit XmlReader(std::string_view xml) : rest_(xml) {}

  /// All elements in the order of their beginnings.
  std::vector<XmlElement> elements() {
    if (rest_.starts_with("<?xml")) take_until("?>");
    while (!rest_.empty()) {
      check_text(rest_.substr(0, rest_.find('<')));
      if (rest_.empty()) break;
      if (rest_.starts_with("</")) {
        take_end();
      } else {
        take_element();
      }
    }
    require(open_.empty() && !found_.empty(), "an element is not closed");
    return found_;
  }

 private:
  static void require(bool holds, const char* fault) {
    if (!holds) throw std::runtime_error(std::string("XML: ") + fault);
  }

  std::string_view take(std::size_t count) {
    require(count <= rest_.size(), "ends early");
    const std::string_view taken = rest_.substr(0, count);
    rest_.remove_prefix(count);
    return taken;
  }
  std::string_view take_until(std::string_view end) {
    const std::size_t at = rest_.find(end);
    require(at != rest_.npos, "ends early");
    return take(at + end.size());
  }
  void skip_blanks() {
    while (!rest_.empty() && (rest_.front() == ' ' || rest_.front() == '\n'))
      take(1);
  }
  std::string take_name() {
    const std::size_t end = rest_.find_first_of(" \n=/><\"'&");
    require(end != 0 && end != rest_.npos, "a name is missing");
    return std::string(take(end));
  }

  /// Text without marks that mean something else, control characters or broken UTF-8.
  static void check_characters(std::string_view text) {
    for (std::size_t i = 0; i < text.size(); ++i) {
      const auto c = static_cast<unsigned char>(text[i]);
      require(c >= 0x20 || c == '\n' || c == '\t' || c == '\r', "a control character");
      require(c != '<', "a bare <");
      if (c == '&') check_entity(text.substr(i));
      if (c >= 0x80) i += check_sequence(text.substr(i));
    }
  }
  static void check_entity(std::string_view text) {
    const std::string_view name = text.substr(0, text.find(';') + 1);
    require(name == "&lt;" || name == "&gt;" || name == "&amp;" || name == "&quot;" ||
                name == "&apos;" || name.starts_with("&#"),
            "a bare &");
  }
  /// How many bytes follow the first one.
  static std::size_t check_sequence(std::string_view text) {
    const auto first = static_cast<unsigned char>(text[0]);
    const std::size_t more = first >= 0xF0 ? 3 : first >= 0xE0 ? 2 : 1;
    require(first >= 0xC2 && first <= 0xF4 && text.size() > more, "no UTF-8");
    for (std::size_t k = 1; k <= more; ++k)
      require((static_cast<unsigned char>(text[k]) & 0xC0U) == 0x80U, "no UTF-8");
    return more;
  }

  void check_text(std::string_view text) {
    check_characters(text);
    require(!open_.empty() || text.find_first_not_of(" \n") == text.npos, "text outside of all");
    take(text.size());
  }

  void take_element() {
    take(1);
    XmlElement element{take_name(), {}};
    for (skip_blanks(); !rest_.starts_with('>') && !rest_.starts_with("/>"); skip_blanks()) {
      const std::string name = take_name();
      require(take(2) == "=\"", "an attribute has no value");
      const std::string_view value = take_until("\"");
      check_characters(value);
      const bool is_new =
          element.attributes.emplace(name, value.substr(0, value.size() - 1)).second;
      require(is_new, "an attribute comes twice");
    }
    const bool is_empty = take(1) == "/";
    if (is_empty) take(1);
    require(!open_.empty() || found_.empty(), "two outermost elements");
    if (!is_empty) open_.push_back(element.name);
    found_.push_back(std::move(element));
  }

  void take_end() {
    take(2);
    const std::string name = take_name();
    require(!open_.empty() && open_.back() == name, "elements do not nest");
    open_.pop_back();
    require(take(1) == ">", "an end tag does not end");
  }

  std::string_view rest_;
  std::vector<std::string> open_;
  std::vector<XmlElement> found_;
};

}  // namespace planish::oracle
