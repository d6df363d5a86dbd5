#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include <planish/io/read_features.h>

#include <fast_float/fast_float.h>

#include "core/number_text.h"
#include "io/file/file_bytes.h"
#include "io/file/text_cursor.h"
#include "io/row_cursor.h"
#include "platform/path.h"

namespace planish {

std::string field_text(const Field& field) {
  if (const auto* word = std::get_if<std::string>(&field)) return *word;
  if (const auto* number = std::get_if<std::int64_t>(&field)) return std::to_string(*number);
  return number_text(std::get<double>(field));
}

std::optional<double> field_number(const Field& field, std::string_view ending) {
  double number = std::numeric_limits<double>::quiet_NaN();
  if (const auto* word = std::get_if<std::string>(&field)) {
    if (!word->ends_with(ending)) return std::nullopt;
    const char* const end = word->data() + word->size() - ending.size();
    const auto parsed = fast_float::from_chars(word->data(), end, number);
    if (parsed.ec != std::errc() || parsed.ptr != end) return std::nullopt;
  } else if (ending.empty()) {
    const auto* whole = std::get_if<std::int64_t>(&field);
    number = whole != nullptr ? static_cast<double>(*whole) : std::get<double>(field);
  }
  return std::isfinite(number) ? std::optional(number) : std::nullopt;
}

std::vector<Field> field_parts(const Field& field) {
  const auto* const word = std::get_if<std::string>(&field);
  if (word == nullptr) return {field};
  std::vector<Field> parts;
  for (std::size_t from = 0; from <= word->size();) {
    const std::size_t to = std::min(word->find(',', from), word->size());
    parts.emplace_back(word->substr(from, to - from));
    from = to + 1;
  }
  return parts;
}

Rows read_rows(const std::filesystem::path& path) {
  const FileBytes file(path);
  return parse_rows(file.view(), utf8_of(path));
}

Rows parse_rows(std::string_view bytes, const std::string& name) {
  TextCursor cursor(bytes, name, {.comments = true});
  Rows rows{name, {}};
  while (cursor.skip_to_token()) {
    Row& row = rows.rows.emplace_back(Row{{}, cursor.line()});
    while (!cursor.at_line_end())
      row.fields.emplace_back(std::string(cursor.token()));
  }
  return rows;
}

std::optional<std::uint64_t> field_count(const Field& field) {
  if (const auto* whole = std::get_if<std::int64_t>(&field))
    return *whole < 0 ? std::nullopt : std::optional(static_cast<std::uint64_t>(*whole));
  const auto* word = std::get_if<std::string>(&field);
  if (word == nullptr) return std::nullopt;
  std::uint64_t number = 0;
  const char* const end = word->data() + word->size();
  const auto parsed = std::from_chars(word->data(), end, number);
  if (parsed.ptr != end || parsed.ec == std::errc::invalid_argument) return std::nullopt;
  return parsed.ec == std::errc() ? number : std::numeric_limits<std::uint64_t>::max();
}

const Field& RowCursor::next(const char* what) {
  if (at_end()) fail(ErrorCode::malformed_file, std::string(what) + " is missing");
  return row_.fields[at_++];
}

std::vector<Index> RowCursor::vertices(std::size_t vertex_count) {
  std::vector<Index> vertices;
  while (!at_end()) {
    for (const Field& part : field_parts(next(""))) {
      if (part != Field("")) vertices.push_back(vertex(part, vertex_count));
    }
  }
  return vertices;
}

void RowCursor::end() {
  if (at_end()) return;
  fail(ErrorCode::malformed_file, "more follows: " + in_quotes(field_text(row_.fields[at_])));
}

Index RowCursor::vertex(const Field& field, std::optional<std::size_t> vertex_count) const {
  constexpr std::uint64_t most = std::numeric_limits<Index>::max();
  const auto number = field_count(field);
  if (!number || (!vertex_count && *number > most)) {
    fail(ErrorCode::bad_number,
         in_quotes(field_text(field)) + " is not the number of a vertex, counted from 0");
  }
  if (vertex_count && *number >= *vertex_count) {
    fail(ErrorCode::index_out_of_range, "there is no vertex " + field_text(field).substr(0, 20) +
                                            ": the mesh has " + std::to_string(*vertex_count) +
                                            " vertices, counted from 0");
  }
  return static_cast<Index>(*number);
}

}  // namespace planish
