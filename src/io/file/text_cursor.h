#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "io/file/cursor_error.h"

namespace planish {

/// What a text format knows besides words and lines.
struct TextSyntax {
  bool comments = false;      ///< from # to the end of the line
  bool continuation = false;  ///< a backslash at the end of a line joins the next one
};

/// Walks over the words of a text and counts its lines, which end in LF, CR LF or CR. Never looks
/// outside the text, and at each byte a bounded number of times.
class TextCursor {
 public:
  /// Skips a UTF-8 byte order mark. `bytes` and `name` must outlive the cursor.
  /// @throws Error malformed_file for UTF-16 and UTF-32
  TextCursor(std::string_view bytes, std::string_view name, TextSyntax syntax = {});

  bool at_end() const { return at_ == end_; }
  std::size_t line() const { return line_; }
  std::size_t offset() const { return static_cast<std::size_t>(at_ - begin_); }
  std::size_t remaining() const { return static_cast<std::size_t>(end_ - at_); }

  /// Whether no word follows on this line.
  bool at_line_end() {
    skip_blanks();
    return at_ == end_ || is_line_end(*at_) || *at_ == comment_;
  }

  /// The next word of this line, empty where there is none.
  std::string_view token();

  /// The characters that end this line where the cursor is at its end; else none.
  std::string_view line_end() const;

  /// Goes to the next word, over as many lines as it takes; false at the end of the text.
  bool skip_to_token();

  /// Goes to the start of the next line.
  void next_line();

  /// The next word of this line as a finite number.
  /// @param non_finite what an error calls it if it is not finite
  /// @throws Error bad_number, non_finite, malformed_file or truncated_file
  double number(ErrorCode non_finite = ErrorCode::non_finite_coordinate);

  /// The next word of this line as a count; more than 64 bits hold becomes the largest.
  /// @throws Error malformed_file or truncated_file
  std::uint64_t count();

  /// To be called behind the last item: tells of words that are left; empty where there are none.
  /// @param faces the number that it announces
  /// @throws Error malformed_file if they begin with a number: there are more items than announced
  std::string rest_note(std::uint64_t faces);

  /// What errors name from now on.
  void begin_item(std::string_view kind, std::size_t number) { item_ = {kind, number}; }

  ReadPlace place() const { return {line_, item_}; }
  [[noreturn]] void fail_at(const ReadPlace& place, ErrorCode code,
                            const std::string& message) const;

  [[noreturn]] void fail(ErrorCode code, const std::string& message) const {
    fail_at_line(line_, code, message);
  }
  [[noreturn]] void fail_at_line(std::size_t line, ErrorCode code,
                                 const std::string& message) const;
  /// Fails because `what` should follow and nothing does.
  [[noreturn]] void fail_missing(const std::string& what) const;

 private:
  static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }
  static bool is_line_end(char c) { return c == '\n' || c == '\r'; }
  bool at_continuation(const char* at) const {
    return *at == '\\' && continuation_ && at + 1 != end_ && is_line_end(at[1]);
  }
  bool ends_word(const char* at) const {
    return at == end_ || is_blank(*at) || is_line_end(*at) || at_continuation(at);
  }
  void skip_blanks();
  void take_line_end();
  [[noreturn]] void fail_number(ErrorCode non_finite);

  const char* begin_;
  const char* at_;
  const char* end_;
  std::size_t line_ = 1;
  std::string_view name_;
  ReadItem item_;
  char comment_;
  bool continuation_;
};

}  // namespace planish
