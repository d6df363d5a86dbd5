#include <charconv>

#include <planish/report/read_furniture.h>

#include "io/file_bytes.h"
#include "io/text_cursor.h"

namespace planish {

namespace {

std::string quoted(std::string_view word) {
  return "\"" + std::string(word.substr(0, 20)) + "\"";
}

Index vertex_in(std::string_view word, const TextCursor& cursor) {
  Index vertex = 0;
  const char* const end = word.data() + word.size();
  const auto parsed = std::from_chars(word.data(), end, vertex);
  if (parsed.ec != std::errc() || parsed.ptr != end) {
    cursor.fail(ErrorCode::bad_number,
                quoted(word) + " is not the number of a vertex, counted from 0");
  }
  return vertex;
}

double share_in(std::string_view word, const TextCursor& cursor) {
  const bool in_percent = word.ends_with('%');
  const std::string_view digits = word.substr(0, word.size() - (in_percent ? 1 : 0));
  double share = 0.0;
  const char* const end = digits.data() + digits.size();
  const auto parsed = std::from_chars(digits.data(), end, share);
  if (parsed.ec != std::errc() || parsed.ptr != end) {
    cursor.fail(ErrorCode::bad_number, quoted(word) + " is not a share such as 0.25 or 25%");
  }
  return in_percent ? share / 100.0 : share;
}

NotchKind notch_kind_in(std::string_view word, const TextCursor& cursor) {
  for (const NotchKind kind : {NotchKind::slit, NotchKind::v, NotchKind::t}) {
    if (word == to_string(kind)) return kind;
  }
  cursor.fail(ErrorCode::unknown_name,
              quoted(word) + " is no kind of notch: there are slit, v and t");
}

MarkKind mark_kind_in(std::string_view word, const TextCursor& cursor) {
  for (const MarkKind kind : {MarkKind::cross, MarkKind::drill}) {
    if (word == to_string(kind)) return kind;
  }
  cursor.fail(ErrorCode::unknown_name,
              quoted(word) + " is no kind of mark: there are cross and drill");
}

void end_line(TextCursor& cursor) {
  if (cursor.at_line_end()) return;
  cursor.fail(ErrorCode::malformed_file, "more follows on the line: " + quoted(cursor.token()));
}

Notch notch_in(TextCursor& cursor) {
  const std::string_view place = cursor.token();
  Notch notch;
  if (place.find_first_of(".%") == std::string_view::npos) {
    notch.place = vertex_in(place, cursor);
  } else {
    notch.place = share_in(place, cursor);
  }
  if (!cursor.at_line_end()) notch.kind = notch_kind_in(cursor.token(), cursor);
  if (!cursor.at_line_end()) {
    const std::string_view word = cursor.token();
    if (word != "double") {
      cursor.fail(ErrorCode::unknown_name, quoted(word) + " should be the word double");
    }
    notch.is_double = true;
  }
  end_line(cursor);
  return notch;
}

Mark mark_in(TextCursor& cursor) {
  Mark mark;
  mark.vertex = vertex_in(cursor.token(), cursor);
  if (!cursor.at_line_end()) mark.kind = mark_kind_in(cursor.token(), cursor);
  end_line(cursor);
  return mark;
}

}  // namespace

std::vector<Notch> parse_notches(std::string_view bytes, const std::string& name) {
  TextCursor cursor(bytes, name, {.comments = true});
  std::vector<Notch> notches;
  while (cursor.skip_to_token())
    notches.push_back(notch_in(cursor));
  return notches;
}

std::vector<Mark> parse_marks(std::string_view bytes, const std::string& name) {
  TextCursor cursor(bytes, name, {.comments = true});
  std::vector<Mark> marks;
  while (cursor.skip_to_token())
    marks.push_back(mark_in(cursor));
  return marks;
}

std::vector<Notch> read_notches(const std::filesystem::path& path) {
  const FileBytes file(path);
  return parse_notches(file.view(), path.string());
}

std::vector<Mark> read_marks(const std::filesystem::path& path) {
  const FileBytes file(path);
  return parse_marks(file.view(), path.string());
}

}  // namespace planish
