#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>

#include "core/number_text.h"
#include "io/append.h"
#include "io/face_list.h"
#include "io/formats.h"
#include "io/text_cursor.h"

namespace planish {
namespace {

/// Statements that say nothing about the surface: passed over without a word.
constexpr std::array<std::string_view, 16> k_attributes = {
    "vn",       "vt",       "g",   "s",      "o",      "usemtl",     "mtllib",    "mg",
    "c_interp", "d_interp", "lod", "usemap", "maplib", "shadow_obj", "trace_obj", "bevel"};

/// Statements of points, lines, curves and free-form surfaces: passed over with a note.
constexpr std::array<std::string_view, 26> k_skipped = {
    "l",    "p",  "vp",  "curv",   "curv2", "surf", "parm", "trim",  "hole",
    "scrv", "sp", "end", "cstype", "deg",   "bmat", "step", "ctech", "stech",
    "con",  "fo", "bzp", "bsp",    "cdc",   "cdp",  "res",  "call"};

/// A vertex that a face names before its statement.
struct ForwardReference {
  std::uint64_t number;  ///< from 1
  std::size_t line;
};

class ObjParser {
 public:
  ObjParser(std::string_view bytes, std::string_view name)
      : cursor_(bytes, name, {.comments = true, .continuation = true}) {}

  ReadResult parse() {
    for (; !cursor_.at_end(); cursor_.next_line())
      statement();
    check();
    return {.mesh = {std::move(positions_), faces_.take()},
            .format = MeshFormat::obj,
            .notes = notes()};
  }

 private:
  void statement() {
    const std::string_view keyword = cursor_.token();
    if (keyword.empty()) return;
    if (keyword == "v") return vertex();
    if (keyword == "f") return face();
    skip(keyword);
  }

  void vertex();
  void face();
  Index corner(std::string_view word);
  void check_references(std::string_view word, std::string_view after_vertex) const;
  std::uint64_t absolute(bool negative, std::uint64_t number, std::string_view word) const;
  void skip(std::string_view keyword);
  void check() const;
  std::vector<std::string> notes() const;

  TextCursor cursor_;
  std::vector<Vec3> positions_;
  FaceList faces_;
  std::vector<Index> corners_;
  std::vector<ForwardReference> forward_;  ///< each larger than those before it
  std::size_t coloured_ = 0;
  std::array<std::size_t, k_skipped.size()> skipped_ = {};
  std::size_t unknown_ = 0;
  std::string first_unknown_;
};

void ObjParser::vertex() {
  const double x = cursor_.number();
  const double y = cursor_.number();
  const double z = cursor_.number();
  std::size_t extras = 0;
  for (; !cursor_.at_line_end(); ++extras)
    cursor_.number();
  // One more number is a weight, three are a colour, four a colour and a weight or opacity.
  if (extras == 2 || extras > 4) {
    cursor_.fail(ErrorCode::malformed_file,
                 "a vertex cannot have " + std::to_string(3 + extras) + " numbers");
  }
  coloured_ += extras >= 3;
  positions_.push_back({x, y, z});
  check_size(positions_.size(), "vertices", cursor_);
}

void ObjParser::face() {
  corners_.clear();
  while (!cursor_.at_line_end())
    corners_.push_back(corner(cursor_.token()));
  faces_.add(corners_, cursor_);
}

/// The vertex, from 0, of a corner like 7, 7/1, 7//3, 7/1/3 or -1.
Index ObjParser::corner(std::string_view word) {
  std::size_t at = word.front() == '-' || word.front() == '+';
  const std::size_t first_digit = at;
  std::uint64_t number = 0;
  for (; at < word.size() && word[at] >= '0' && word[at] <= '9'; ++at) {
    // Large numbers stay large; they are out of range however large they are.
    if (number <= k_most_items) number = 10 * number + static_cast<std::uint64_t>(word[at] - '0');
  }
  if (at == first_digit || (at < word.size() && word[at] != '/')) {
    cursor_.fail(ErrorCode::bad_number, in_quotes(word) + " is not a corner of a face");
  }
  if (at < word.size()) check_references(word, word.substr(at));
  number = absolute(word.front() == '-', number, word);
  if (number > positions_.size() && (forward_.empty() || number > forward_.back().number)) {
    forward_.push_back({number, cursor_.line()});
  }
  return static_cast<Index>(number - 1);
}

void ObjParser::check_references(std::string_view word, std::string_view after_vertex) const {
  if (after_vertex.find_first_not_of("/+-0123456789") == std::string_view::npos &&
      std::count(after_vertex.begin(), after_vertex.end(), '/') <= 2) {
    return;
  }
  cursor_.fail(ErrorCode::bad_number, in_quotes(word) + " is not a corner of a face");
}

/// The number from 1 for a number that may count back from the last vertex so far.
std::uint64_t ObjParser::absolute(bool negative, std::uint64_t number,
                                  std::string_view word) const {
  const std::size_t so_far = positions_.size();
  if (number == 0) {
    cursor_.fail(ErrorCode::index_out_of_range,
                 "the face refers to vertex 0, but OBJ counts from 1");
  }
  if (negative && number > so_far) {
    cursor_.fail(ErrorCode::index_out_of_range, "the face refers to vertex " + in_quotes(word) +
                                                    " but only " + std::to_string(so_far) +
                                                    " vertices come before it");
  }
  if (number > k_most_items) {
    cursor_.fail(ErrorCode::index_out_of_range,
                 "the face refers to vertex " + in_quotes(word) + ", which cannot exist");
  }
  return negative ? so_far + 1 - number : number;
}

void ObjParser::skip(std::string_view keyword) {
  if (std::find(k_attributes.begin(), k_attributes.end(), keyword) != k_attributes.end()) return;
  const auto kind = std::find(k_skipped.begin(), k_skipped.end(), keyword);
  if (kind != k_skipped.end()) {
    ++skipped_[static_cast<std::size_t>(kind - k_skipped.begin())];
    return;
  }
  if (unknown_++ == 0) {
    first_unknown_ = in_quotes(keyword) + " on line " + std::to_string(cursor_.line());
  }
}

void ObjParser::check() const {
  if (positions_.empty() && faces_.size() == 0 && unknown_ > 0) {
    cursor_.fail_at_line(1, ErrorCode::malformed_file,
                         "no OBJ statement found; the first word is " + first_unknown_);
  }
  for (const auto& reference : forward_) {
    if (reference.number <= positions_.size()) continue;
    cursor_.fail_at_line(reference.line, ErrorCode::index_out_of_range,
                         "the face refers to vertex " + std::to_string(reference.number) +
                             " but the file has " + std::to_string(positions_.size()) +
                             " vertices");
  }
  if (faces_.size() > 0) return;
  cursor_.fail(ErrorCode::no_triangles, positions_.empty()
                                            ? std::string("the file has no vertices and no faces")
                                            : "the file has " + std::to_string(positions_.size()) +
                                                  " vertices but no faces");
}

std::vector<std::string> ObjParser::notes() const {
  std::vector<std::string> notes;
  if (!faces_.note().empty()) notes.push_back(faces_.note());
  if (coloured_ > 0) {
    notes.push_back("dropped the colours of " + std::to_string(coloured_) + " vertices");
  }
  std::size_t total = 0;
  std::string kinds;
  for (std::size_t i = 0; i < skipped_.size(); ++i) {
    if (skipped_[i] == 0) continue;
    total += skipped_[i];
    kinds += (kinds.empty() ? "" : ", ") + std::string(k_skipped[i]);
  }
  if (total > 0) {
    notes.push_back("skipped " + std::to_string(total) + " statements of kinds " + kinds);
  }
  if (unknown_ > 0) {
    notes.push_back("skipped " + std::to_string(unknown_) + " unknown statements, the first " +
                    first_unknown_);
  }
  return notes;
}

}  // namespace

ReadResult parse_obj(std::string_view bytes, std::string_view name) {
  return ObjParser(bytes, name).parse();
}

std::string format_obj(const TriMesh& mesh) {
  std::string text;
  text.reserve(60 * mesh.positions.size() + 24 * mesh.triangles.size());
  for (const Vec3& p : mesh.positions) {
    text += 'v';
    for (const double c : {p.x, p.y, p.z})
      append_number(text += ' ', c);
    text += '\n';
  }
  for (const Triangle& triangle : mesh.triangles) {
    text += 'f';
    // A wider type: from 1 on the largest Index has no successor.
    for (const std::uint64_t v : triangle)
      append_integer(text += ' ', v + 1);
    text += '\n';
  }
  return text;
}

}  // namespace planish
