#include "io/formats/ply_header.h"

#include <algorithm>
#include <array>
#include <utility>

namespace planish {
namespace {

constexpr std::array<std::pair<std::string_view, PlyType>, 16> k_types = {{
    {"char", PlyType::int8},
    {"int8", PlyType::int8},
    {"uchar", PlyType::uint8},
    {"uint8", PlyType::uint8},
    {"short", PlyType::int16},
    {"int16", PlyType::int16},
    {"ushort", PlyType::uint16},
    {"uint16", PlyType::uint16},
    {"int", PlyType::int32},
    {"int32", PlyType::int32},
    {"uint", PlyType::uint32},
    {"uint32", PlyType::uint32},
    {"float", PlyType::float32},
    {"float32", PlyType::float32},
    {"double", PlyType::float64},
    {"float64", PlyType::float64},
}};

constexpr std::array<std::pair<std::string_view, PlyEncoding>, 3> k_encodings = {{
    {"ascii", PlyEncoding::ascii},
    {"binary_little_endian", PlyEncoding::little_endian},
    {"binary_big_endian", PlyEncoding::big_endian},
}};

/// The next word of the line, as the value that the table gives it.
template <class Table>
auto one_of(const Table& table, const char* what, TextCursor& cursor) {
  const std::string_view word = cursor.token();
  if (word.empty()) cursor.fail_missing(what);
  for (const auto& [name, value] : table) {
    if (name == word) return value;
  }
  cursor.fail(ErrorCode::malformed_file, in_quotes(word) + " is not " + what);
}

std::string_view name_word(TextCursor& cursor) {
  const std::string_view word = cursor.token();
  if (word.empty()) cursor.fail_missing("a name");
  return word;
}

PlyProperty read_property(TextCursor& cursor) {
  TextCursor ahead = cursor;
  std::optional<PlyType> count_type;
  if (ahead.token() == "list") {
    cursor = ahead;
    count_type = one_of(k_types, "a type of PLY", cursor);
  }
  const PlyType type = one_of(k_types, "a type of PLY", cursor);
  return {.name = name_word(cursor), .type = type, .count_type = count_type};
}

PlyElement read_element(TextCursor& cursor) {
  const std::string_view name = name_word(cursor);
  return {.name = name, .count = cursor.count(), .properties = {}};
}

/// Collects the statements between "ply" and "end_header".
class HeaderParser {
 public:
  explicit HeaderParser(TextCursor& cursor) : cursor_(cursor) {}

  void statement(std::string_view keyword) {
    if (keyword == "format") {
      encoding_ = one_of(k_encodings, "an encoding of PLY", cursor_);
    } else if (keyword == "element") {
      add(read_element(cursor_));
    } else if (keyword == "property") {
      if (elements_.empty()) {
        cursor_.fail(ErrorCode::malformed_file, "a property comes before the first element");
      }
      add(read_property(cursor_));
    } else if (keyword != "comment" && keyword != "obj_info") {
      cursor_.fail(ErrorCode::malformed_file,
                   in_quotes(keyword) + " is not a statement of a PLY header");
    }
  }

  PlyHeader finish(std::size_t body) {
    if (!encoding_) cursor_.fail(ErrorCode::malformed_file, "the header names no format");
    for (const PlyElement& element : elements_) {
      if (!element.properties.empty() || element.count == 0) continue;
      cursor_.fail(ErrorCode::malformed_file,
                   "the element " + in_quotes(element.name) + " has no properties");
    }
    return {.encoding = *encoding_, .elements = std::move(elements_), .body = body};
  }

 private:
  void add(PlyElement element) {
    // Elements of other names are skipped, so they may repeat.
    bool other = false;
    bool& seen = element.name == "vertex" ? has_vertex_
                 : element.name == "face" ? has_face_
                                          : other;
    if (std::exchange(seen, true)) {
      cursor_.fail(ErrorCode::malformed_file,
                   "the element " + in_quotes(element.name) + " comes twice");
    }
    elements_.push_back(std::move(element));
  }

  void add(const PlyProperty& property) {
    // Others are skipped, so they may repeat.
    constexpr std::array<std::string_view, 5> k_read = {"x", "y", "z", "vertex_indices",
                                                        "vertex_index"};
    PlyElement& element = elements_.back();
    if (std::find(k_read.begin(), k_read.end(), property.name) != k_read.end() &&
        element.find(property.name) != nullptr) {
      cursor_.fail(ErrorCode::malformed_file,
                   "the property " + in_quotes(property.name) + " comes twice");
    }
    element.properties.push_back(property);
  }

  TextCursor& cursor_;
  std::optional<PlyEncoding> encoding_;
  std::vector<PlyElement> elements_;
  bool has_vertex_ = false;
  bool has_face_ = false;
};

}  // namespace

const PlyProperty* PlyElement::find(std::string_view property) const {
  const auto found = std::find_if(properties.begin(), properties.end(),
                                  [&](const PlyProperty& p) { return p.name == property; });
  return found == properties.end() ? nullptr : &*found;
}

const PlyElement* PlyHeader::find(std::string_view element) const {
  const auto found = std::find_if(elements.begin(), elements.end(),
                                  [&](const PlyElement& e) { return e.name == element; });
  return found == elements.end() ? nullptr : &*found;
}

const PlyProperty* group_property(const PlyElement& faces) {
  constexpr std::array<std::string_view, 8> k_names = {
      "patch", "patch_id", "group", "group_id", "label", "labels", "segment", "segment_id"};
  for (const std::string_view name : k_names) {
    const PlyProperty* const found = faces.find(name);
    if (found == nullptr || found->count_type) continue;
    if (found->type != PlyType::float32 && found->type != PlyType::float64) return found;
  }
  return nullptr;
}

std::size_t size_of(PlyType type) {
  constexpr std::array<std::size_t, 8> k_sizes = {1, 1, 2, 2, 4, 4, 4, 8};
  return k_sizes[static_cast<std::size_t>(type)];
}

PlyHeader read_ply_header(TextCursor& cursor) {
  if (cursor.token() != "ply" || !cursor.at_line_end()) {
    cursor.fail(ErrorCode::malformed_file, "a PLY file begins with a line \"ply\"");
  }
  const std::string_view line_end = cursor.line_end();
  cursor.next_line();
  HeaderParser parser(cursor);
  while (!cursor.at_end()) {
    const std::string_view keyword = cursor.token();
    if (keyword == "end_header") {
      if (!cursor.at_line_end()) {
        cursor.fail(ErrorCode::malformed_file, "the line of end_header goes on");
      }
      // Where the header's line ends are CR, a LF that follows is data. Else CR LF is a line end,
      // whatever the others are: some writers open the file as text, and then as bytes.
      const std::size_t size = line_end == "\r" ? 1 : cursor.line_end().size();
      const std::size_t body = cursor.offset() + size;
      cursor.next_line();
      return parser.finish(body);
    }
    if (!keyword.empty()) parser.statement(keyword);
    cursor.next_line();
  }
  cursor.fail(ErrorCode::truncated_file, "the header has no end_header");
}

}  // namespace planish
