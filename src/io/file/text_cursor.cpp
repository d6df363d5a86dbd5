#include "io/file/text_cursor.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include <fast_float/fast_float.h>

#include "io/file/file_type_sniffer.h"

namespace planish {

// Without comments the sign of a comment is a line end, which stops a line anyway.
TextCursor::TextCursor(std::string_view bytes, std::string_view name, TextSyntax syntax)
    : begin_(bytes.data()),
      at_(begin_),
      end_(begin_ + bytes.size()),
      name_(name),
      comment_(syntax.comments ? '#' : '\n'),
      continuation_(syntax.continuation) {
  if (const std::string_view encoding = wide_encoding(bytes); !encoding.empty()) {
    fail(ErrorCode::malformed_file,
         "the text is encoded in " + std::string(encoding) + "; save it as UTF-8 or ASCII");
  }
  if (bytes.starts_with("\xef\xbb\xbf")) at_ += 3;
}

void TextCursor::skip_blanks() {
  while (at_ != end_) {
    if (is_blank(*at_)) {
      ++at_;
    } else if (at_continuation(at_)) {
      ++at_;
      take_line_end();
    } else {
      return;
    }
  }
}

void TextCursor::take_line_end() {
  const bool carriage_return = *at_++ == '\r';
  if (carriage_return && at_ != end_ && *at_ == '\n') ++at_;
  ++line_;
}

std::string_view TextCursor::token() {
  if (at_line_end()) return {};
  const char* const first = at_;
  while (!ends_word(at_))
    ++at_;
  return {first, static_cast<std::size_t>(at_ - first)};
}

std::string_view TextCursor::line_end() const {
  const std::string_view text(at_, remaining());
  if (text.starts_with("\r\n")) return text.substr(0, 2);
  return text.starts_with('\r') || text.starts_with('\n') ? text.substr(0, 1) : std::string_view();
}

bool TextCursor::skip_to_token() {
  while (at_line_end()) {
    if (at_ == end_) return false;
    next_line();
  }
  return true;
}

void TextCursor::next_line() {
  while (at_ != end_) {
    if (is_line_end(*at_)) return take_line_end();
    if (*at_ == comment_) {
      // A backslash at the end of a comment belongs to the comment.
      while (at_ != end_ && !is_line_end(*at_))
        ++at_;
    } else if (at_continuation(at_)) {
      ++at_;
      take_line_end();
    } else {
      ++at_;
    }
  }
}

double TextCursor::number(ErrorCode non_finite) {
  if (at_line_end()) fail_missing("a number");
  const char* first = at_;
  if (*first == '+' && first + 1 != end_ && first[1] != '-') ++first;
  double value = 0.0;
  const auto [last, fault] = fast_float::from_chars(first, end_, value);
  if (fault != std::errc() || !ends_word(last) || !std::isfinite(value)) fail_number(non_finite);
  at_ = last;
  return value;
}

void TextCursor::fail_number(ErrorCode non_finite) {
  const std::string_view word = token();
  const std::string_view digits = word.substr(word.starts_with('+') || word.starts_with('-'));
  const auto has = [digits](std::string_view set) {
    return digits.find_first_of(set) != std::string_view::npos;
  };
  double value = 0.0;
  const auto parsed = fast_float::from_chars(digits.data(), digits.data() + digits.size(), value);
  const bool is_number =
      parsed.ec == std::errc() && parsed.ptr == digits.data() + digits.size() && !has("+-");
  if (is_number && (std::isnan(value) || (std::isinf(value) && !has("0123456789")))) {
    fail(non_finite, in_quotes(word) + " is not a finite number");
  }
  if (is_number && !std::isfinite(value)) {
    fail(ErrorCode::bad_number, in_quotes(word) + " is too large for a double");
  }
  fail(ErrorCode::bad_number, in_quotes(word) + " is not a number" +
                                  (has(",") ? "; decimals need a point, not a comma" : ""));
}

std::uint64_t TextCursor::count() {
  const std::string_view word = token();
  if (word.empty()) fail_missing("a count");
  std::uint64_t value = 0;
  const char* const last = word.data() + word.size();
  const auto parsed = std::from_chars(word.data(), last, value);
  if (parsed.ptr != last || parsed.ec == std::errc::invalid_argument) {
    fail(ErrorCode::malformed_file, in_quotes(word) + " is not a count");
  }
  return parsed.ec == std::errc() ? value : std::numeric_limits<std::uint64_t>::max();
}

std::string TextCursor::rest_note(std::uint64_t faces) {
  item_ = {};
  if (!skip_to_token()) return {};
  const std::size_t line = line_;
  const std::string_view word = token();
  if (word.find_first_of("0123456789") == std::string_view::npos) {
    return "ignored what follows the last item, from line " + std::to_string(line) + " on";
  }
  fail(ErrorCode::malformed_file, "the file goes on with " + in_quotes(word) + " after the " +
                                      std::to_string(faces) + (faces == 1 ? " face" : " faces") +
                                      " that it announces");
}

void TextCursor::fail_at_line(std::size_t line, ErrorCode code, const std::string& message) const {
  fail_at({line, item_}, code, message);
}

void TextCursor::fail_at(const ReadPlace& place, ErrorCode code, const std::string& message) const {
  throw_read_error(code, message, {.path = std::string(name_), .line = place.at}, place.item);
}

void TextCursor::fail_missing(const std::string& what) const {
  if (at_end()) fail(ErrorCode::truncated_file, "the file ends where " + what + " should follow");
  fail(ErrorCode::malformed_file, "the line ends where " + what + " should follow");
}

}  // namespace planish
