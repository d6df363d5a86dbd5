#include <array>
#include <optional>

#include <planish/pattern/read_annotations.h>

#include "io/file/cursor_error.h"
#include "io/row_cursor.h"

namespace planish {

namespace {

/// A share as 0.25 or 25%; nothing where it is none.
std::optional<double> share_of(const Field& field) {
  if (const auto percent = field_number(field, "%")) return *percent / 100.0;
  return field_number(field);
}

/// The kind that the next field names, or the first one where none is left.
template <std::size_t N, class Kind>
Kind kind_in(RowCursor& cursor, const std::array<Kind, N>& kinds, const char* fault) {
  if (cursor.at_end()) return kinds.front();
  const std::string word = field_text(cursor.next(""));
  for (const Kind kind : kinds) {
    if (word == to_string(kind)) return kind;
  }
  cursor.fail(ErrorCode::unknown_name, in_quotes(word) + fault);
}

/// What follows the place of a notch: its form.
template <class SomeNotch>
void read_notch_form(RowCursor& cursor, SomeNotch& form) {
  form.kind = kind_in(cursor, std::array{NotchKind::slit, NotchKind::v, NotchKind::t},
                      " is no kind of notch: there are slit, v and t");
  if (!cursor.at_end()) {
    const std::string word = field_text(cursor.next(""));
    if (word != "double")
      cursor.fail(ErrorCode::unknown_name, in_quotes(word) + " should be the word double");
    form.is_double = true;
  }
  cursor.end();
}

/// A share of the border where there is a point or a %, or a number that is not whole by its kind.
bool is_share(const Field& place) {
  const auto* const word = std::get_if<std::string>(&place);
  return word == nullptr ? std::holds_alternative<double>(place)
                         : word->find_first_of(".%") != std::string::npos;
}

Notch notch_in(RowCursor& cursor) {
  const Field& place = cursor.next("the place");
  const auto share = is_share(place) ? share_of(place) : std::nullopt;
  if (is_share(place) && !share) {
    cursor.fail(ErrorCode::bad_number,
                in_quotes(field_text(place)) + " is not a share such as 0.25 or 25%");
  }
  Notch notch = share ? Notch::at_fraction(*share) : Notch::at_vertex(cursor.vertex(place));
  read_notch_form(cursor, notch);
  return notch;
}

std::optional<std::size_t> seam_in(RowCursor& cursor) {
  const Field& field = cursor.next("the seam");
  if (field == Field("*")) return std::nullopt;
  if (const auto number = field_count(field); number && *number > 0) return *number - 1;
  cursor.fail(ErrorCode::bad_number,
              in_quotes(field_text(field)) + " is not the number of a seam, counted from 1, or *");
}

SeamNotch seam_notch_in(RowCursor& cursor) {
  SeamNotch notch;
  notch.seam = seam_in(cursor);
  const Field& place = cursor.next("the place, such as 50% or 120mm,");
  const auto length = field_number(place, "mm");
  const auto share = share_of(place);
  if (!length && !share) {
    cursor.fail(ErrorCode::bad_number,
                in_quotes(field_text(place)) + " is no place such as 0.5, 50% or 120mm");
  }
  notch.in_millimetres = length.has_value();
  notch.place = length ? *length : *share;
  read_notch_form(cursor, notch);
  return notch;
}

EdgeAllowance edge_allowance_in(RowCursor& cursor) {
  EdgeAllowance edge;
  edge.from = cursor.vertex(cursor.next("the vertex where the stretch begins"));
  edge.to = cursor.vertex(cursor.next("the vertex where the stretch ends"));
  const Field& field = cursor.next("the width");
  const std::string word = in_quotes(field_text(field));
  const auto with_unit = field_number(field, "mm");
  const auto width = with_unit ? with_unit : field_number(field);
  if (!width) cursor.fail(ErrorCode::bad_number, word + " is no width such as 12.5mm");
  if (*width < 0.0)
    cursor.fail(ErrorCode::option_out_of_range, "the width " + word + " is below 0");
  edge.width = *width;
  cursor.end();
  return edge;
}

Mark mark_in(RowCursor& cursor) {
  Mark mark;
  mark.vertex = cursor.vertex(cursor.next("the vertex"));
  mark.kind = kind_in(cursor, std::array{MarkKind::cross, MarkKind::drill},
                      " is no kind of mark: there are cross and drill");
  cursor.end();
  return mark;
}

InnerLine inner_line_in(RowCursor& cursor) {
  InnerLine line = {cursor.vertex(cursor.next("the vertex"))};
  do {
    line.push_back(cursor.vertex(cursor.next("a second vertex")));
  } while (!cursor.at_end());
  return line;
}

/// What each row says.
template <class Item>
std::vector<Item> items_in(const Rows& rows, Item (*item_in)(RowCursor&)) {
  std::vector<Item> items;
  for (const Row& row : rows.rows) {
    RowCursor cursor(rows, row);
    items.push_back(item_in(cursor));
  }
  return items;
}

}  // namespace

std::vector<Notch> notches_in(const Rows& rows) {
  return items_in(rows, notch_in);
}

std::vector<Mark> marks_in(const Rows& rows) {
  return items_in(rows, mark_in);
}

std::vector<InnerLine> inner_lines_in(const Rows& rows) {
  return items_in(rows, inner_line_in);
}

std::vector<EdgeAllowance> edge_allowances_in(const Rows& rows) {
  return items_in(rows, edge_allowance_in);
}

std::vector<SeamNotch> seam_notches_in(const Rows& rows) {
  return items_in(rows, seam_notch_in);
}

}  // namespace planish
