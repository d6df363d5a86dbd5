#include <charconv>
#include <cmath>
#include <optional>

#include <planish/pattern/read_annotations.h>

#include <fast_float/fast_float.h>

#include "io/file/file_bytes.h"
#include "io/file/text_cursor.h"
#include "platform/path.h"

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

std::string_view next_word(TextCursor& cursor, const char* what) {
  if (!cursor.at_line_end()) return cursor.token();
  cursor.fail(ErrorCode::malformed_file, std::string(what) + " is missing");
}

/// The number before the end of a word; nothing where that is none.
std::optional<double> number_before(std::string_view word, std::string_view ending) {
  if (!word.ends_with(ending)) return std::nullopt;
  const char* const end = word.data() + word.size() - ending.size();
  double number = 0.0;
  const auto parsed = fast_float::from_chars(word.data(), end, number);
  if (parsed.ec != std::errc() || parsed.ptr != end || !std::isfinite(number)) return std::nullopt;
  return number;
}

/// A share as 0.25 or 25%; nothing where it is none.
std::optional<double> share_of(std::string_view word) {
  if (const auto percent = number_before(word, "%")) return *percent / 100.0;
  return number_before(word, "");
}

double share_in(std::string_view word, const TextCursor& cursor) {
  if (const auto share = share_of(word)) return *share;
  cursor.fail(ErrorCode::bad_number, quoted(word) + " is not a share such as 0.25 or 25%");
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

/// What follows the place of a notch: its form.
template <class SomeNotch>
void read_notch_form(TextCursor& cursor, SomeNotch& form) {
  if (!cursor.at_line_end()) form.kind = notch_kind_in(cursor.token(), cursor);
  if (!cursor.at_line_end()) {
    const std::string_view word = cursor.token();
    if (word != "double") {
      cursor.fail(ErrorCode::unknown_name, quoted(word) + " should be the word double");
    }
    form.is_double = true;
  }
  end_line(cursor);
}

Notch notch_in(TextCursor& cursor) {
  const std::string_view place = cursor.token();
  Notch notch = place.find_first_of(".%") == std::string_view::npos
                    ? Notch::at_vertex(vertex_in(place, cursor))
                    : Notch::at_fraction(share_in(place, cursor));
  read_notch_form(cursor, notch);
  return notch;
}

std::optional<std::size_t> seam_in(std::string_view word, const TextCursor& cursor) {
  if (word == "*") return std::nullopt;
  std::size_t number = 0;
  const char* const end = word.data() + word.size();
  const auto parsed = std::from_chars(word.data(), end, number);
  if (parsed.ec == std::errc() && parsed.ptr == end && number > 0) return number - 1;
  cursor.fail(ErrorCode::bad_number,
              quoted(word) + " is not the number of a seam, counted from 1, or *");
}

SeamNotch seam_notch_in(TextCursor& cursor) {
  SeamNotch notch;
  notch.seam = seam_in(cursor.token(), cursor);
  const std::string_view place = next_word(cursor, "the place, such as 50% or 120mm,");
  const auto length = number_before(place, "mm");
  const auto share = share_of(place);
  if (!length && !share) {
    cursor.fail(ErrorCode::bad_number, quoted(place) + " is no place such as 0.5, 50% or 120mm");
  }
  notch.in_millimetres = length.has_value();
  notch.place = length ? *length : *share;
  read_notch_form(cursor, notch);
  return notch;
}

EdgeAllowance edge_allowance_in(TextCursor& cursor) {
  EdgeAllowance edge;
  edge.from = vertex_in(cursor.token(), cursor);
  edge.to = vertex_in(next_word(cursor, "the vertex where the stretch ends"), cursor);
  const std::string_view word = next_word(cursor, "the width");
  const auto with_unit = number_before(word, "mm");
  const auto width = with_unit ? with_unit : number_before(word, "");
  if (!width) cursor.fail(ErrorCode::bad_number, quoted(word) + " is no width such as 12.5mm");
  if (*width < 0.0) {
    cursor.fail(ErrorCode::option_out_of_range, "the width " + quoted(word) + " is below 0");
  }
  edge.width = *width;
  end_line(cursor);
  return edge;
}

Mark mark_in(TextCursor& cursor) {
  Mark mark;
  mark.vertex = vertex_in(cursor.token(), cursor);
  if (!cursor.at_line_end()) mark.kind = mark_kind_in(cursor.token(), cursor);
  end_line(cursor);
  return mark;
}

InnerLine inner_line_in(TextCursor& cursor) {
  InnerLine line = {vertex_in(cursor.token(), cursor)};
  line.push_back(vertex_in(next_word(cursor, "a second vertex"), cursor));
  while (!cursor.at_line_end())
    line.push_back(vertex_in(cursor.token(), cursor));
  return line;
}

/// What each line that is not empty says.
template <class Item>
std::vector<Item> items_in(std::string_view bytes, const std::string& name,
                           Item (*item_in)(TextCursor&)) {
  TextCursor cursor(bytes, name, {.comments = true});
  std::vector<Item> items;
  while (cursor.skip_to_token())
    items.push_back(item_in(cursor));
  return items;
}

template <class Item>
std::vector<Item> items_of(const std::filesystem::path& path, Item (*item_in)(TextCursor&)) {
  const FileBytes file(path);
  return items_in(file.view(), utf8_of(path), item_in);
}

}  // namespace

std::vector<Notch> parse_notches(std::string_view bytes, const std::string& name) {
  return items_in(bytes, name, notch_in);
}

std::vector<Mark> parse_marks(std::string_view bytes, const std::string& name) {
  return items_in(bytes, name, mark_in);
}

std::vector<InnerLine> parse_inner_lines(std::string_view bytes, const std::string& name) {
  return items_in(bytes, name, inner_line_in);
}

std::vector<EdgeAllowance> parse_edge_allowances(std::string_view bytes, const std::string& name) {
  return items_in(bytes, name, edge_allowance_in);
}

std::vector<SeamNotch> parse_seam_notches(std::string_view bytes, const std::string& name) {
  return items_in(bytes, name, seam_notch_in);
}

std::vector<Notch> read_notches(const std::filesystem::path& path) {
  return items_of(path, notch_in);
}

std::vector<Mark> read_marks(const std::filesystem::path& path) {
  return items_of(path, mark_in);
}

std::vector<InnerLine> read_inner_lines(const std::filesystem::path& path) {
  return items_of(path, inner_line_in);
}

std::vector<EdgeAllowance> read_edge_allowances(const std::filesystem::path& path) {
  return items_of(path, edge_allowance_in);
}

std::vector<SeamNotch> read_seam_notches(const std::filesystem::path& path) {
  return items_of(path, seam_notch_in);
}

}  // namespace planish
