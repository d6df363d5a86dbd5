#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/file/cursor_error.h"

namespace planish {

/// A start or an end of an element of XML.
struct MarkupTag {
  enum class Kind {
    start,  ///< also of an empty element, whose end follows
    end,
    none,  ///< at the end of the file
  };

  Kind kind = Kind::none;
  std::string_view name;
  std::size_t line = 0;  ///< of the file, on which it begins
  /// Of starts, in the order of the file. Entities are not replaced: see attribute().
  std::vector<std::pair<std::string_view, std::string_view>> attributes = {};

  /// The value of an attribute with the predefined entities and those of numbers replaced; empty
  /// where there is none.
  std::string attribute(std::string_view name) const;
};

/// Walks over the elements of an XML file, without its text. Refuses what is not well-formed as far
/// as that matters here; never looks outside the bytes, and at each a bounded number of times.
class MarkupReader {
 public:
  /// `bytes` and `name` must outlive the reader.
  /// @throws Error malformed_file for UTF-16 and UTF-32
  MarkupReader(std::string_view bytes, std::string_view name);

  /// The next start or end of an element.
  /// @throws Error malformed_file, truncated_file, too_large (too deep); the place has the line
  MarkupTag next();

  [[noreturn]] void fail(ErrorCode code, const std::string& message, std::size_t line) const;

 private:
  bool at(std::string_view text) const { return bytes_.substr(offset_).starts_with(text); }
  void go_to(std::size_t offset);
  void skip_past(std::string_view end, const char* what);
  void skip_declaration();
  void skip_blanks();
  std::string_view word(const char* what);
  std::string_view quoted_value();
  MarkupTag start_tag();
  MarkupTag end_tag();

  std::string_view bytes_, name_;
  std::size_t offset_ = 0, line_ = 1;
  std::vector<std::string_view> open_;
  bool is_empty_ = false;  // the element that was begun last has no content
};

}  // namespace planish
