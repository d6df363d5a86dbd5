#include <algorithm>
#include <array>
#include <cstdint>

#include "core/number_text.h"
#include "io/file/append.h"
#include "io/file/text_cursor.h"
#include "io/formats/face_list.h"
#include "io/formats/formats.h"

namespace planish {
namespace {

/// The first words of a file whose vertices begin with x y z. Colours, normals and texture
/// coordinates follow on the same line.
constexpr std::array<std::string_view, 8> k_headers = {"OFF",   "COFF",   "NOFF",   "STOFF",
                                                       "CNOFF", "STCOFF", "STNOFF", "STCNOFF"};

/// The fewest bytes of "0 0 0\n" and of "3 0 1 2\n".
constexpr std::uint64_t k_vertex_bytes = 6;
constexpr std::uint64_t k_face_bytes = 8;

class OffParser {
 public:
  OffParser(std::string_view bytes, std::string_view name, const ReadOptions& options)
      : cursor_(bytes, name, {.comments = true}), faces_(options.strict) {}

  ReadResult parse() {
    header();
    counts();
    positions_.reserve(vertex_count_);
    for (std::uint64_t i = 0; i < vertex_count_; ++i)
      vertex(i);
    faces_.reserve(face_count_);
    for (std::uint64_t i = 0; i < face_count_; ++i)
      face(i);
    std::string rest = cursor_.rest_note(face_count_);
    std::vector<std::string> read_notes = notes();
    if (!rest.empty()) read_notes.push_back(std::move(rest));
    std::vector<Triangle> triangles = faces_.take(positions_, cursor_);
    return {.mesh = {std::move(positions_), std::move(triangles)},
            .format = MeshFormat::off,
            .notes = std::move(read_notes)};
  }

 private:
  void header() {
    if (!cursor_.skip_to_token()) cursor_.fail(ErrorCode::no_triangles, "the file has no faces");
    const std::string_view word = cursor_.token();
    if (std::find(k_headers.begin(), k_headers.end(), word) == k_headers.end()) {
      const bool variant = word.size() < 12 && word.ends_with("OFF");
      cursor_.fail(variant ? ErrorCode::unsupported_format : ErrorCode::malformed_file,
                   variant ? "OFF files of the kind " + in_quotes(word) + " are not supported"
                           : "an OFF file begins with OFF, not with " + in_quotes(word));
    }
  }

  void counts() {
    cursor_.skip_to_token();
    const TextCursor before = cursor_;
    if (cursor_.token() == "BINARY") {
      cursor_.fail(ErrorCode::unsupported_format, "binary OFF files are not supported");
    }
    cursor_ = before;
    vertex_count_ = cursor_.count();
    face_count_ = cursor_.count();
    if (!cursor_.at_line_end()) cursor_.count();  // edges: often 0, never needed
    // A line end is missing at most at the end of the file.
    const std::uint64_t most = cursor_.remaining();
    if (vertex_count_ > most || face_count_ > most ||
        vertex_count_ * k_vertex_bytes + face_count_ * k_face_bytes > most + 1) {
      cursor_.fail(ErrorCode::truncated_file,
                   "the file announces " + std::to_string(vertex_count_) + " vertices and " +
                       std::to_string(face_count_) + " faces, but only " + std::to_string(most) +
                       " bytes follow");
    }
    check_size(vertex_count_, "vertices", cursor_);
    if (face_count_ == 0) cursor_.fail(ErrorCode::no_triangles, "the file has no faces");
    cursor_.next_line();
  }

  void vertex(std::uint64_t number) {
    begin_line("vertex", number);
    const double x = cursor_.number();
    const double y = cursor_.number();
    const double z = cursor_.number();
    positions_.push_back({x, y, z});
    check_extras(number);
    cursor_.next_line();
  }

  /// Where only some have more numbers than others, faces have been taken for vertices.
  void check_extras(std::uint64_t number) {
    std::size_t extras = 0;
    for (; !cursor_.at_line_end(); ++extras)
      cursor_.token();
    if (number == 0) extras_ = extras;
    if (extras != extras_) {
      cursor_.fail(ErrorCode::malformed_file, "its line has " + std::to_string(3 + extras) +
                                                  " numbers, but that of vertex 0 has " +
                                                  std::to_string(3 + extras_));
    }
  }

  void face(std::uint64_t number) {
    begin_line("face", number);
    const std::uint64_t corners = cursor_.count();
    corners_.clear();
    for (std::uint64_t i = 0; i < corners; ++i) {
      corners_.push_back(checked_index(cursor_.number(), vertex_count_, cursor_));
    }
    faces_.add(corners_, cursor_);
    cursor_.next_line();  // a colour may follow
  }

  void begin_line(std::string_view kind, std::uint64_t number) {
    cursor_.begin_item(kind, number);
    cursor_.skip_to_token();
  }

  std::vector<std::string> notes() const {
    std::vector<std::string> notes;
    for (std::string& note : faces_.notes())
      notes.push_back(std::move(note));
    if (extras_ > 0) {
      notes.push_back("dropped the colours, normals or texture coordinates of " +
                      std::to_string(vertex_count_) + " vertices");
    }
    return notes;
  }

  TextCursor cursor_;
  std::uint64_t vertex_count_ = 0;
  std::uint64_t face_count_ = 0;
  std::vector<Vec3> positions_;
  FaceList faces_;
  std::vector<Index> corners_;
  std::size_t extras_ = 0;  // numbers behind x y z, the same for all vertices
};

}  // namespace

ReadResult parse_off(std::string_view bytes, std::string_view name, const ReadOptions& options) {
  return OffParser(bytes, name, options).parse();
}

std::string format_off(const TriMesh& mesh) {
  std::string text = "OFF\n";
  text.reserve(60 * mesh.positions.size() + 24 * mesh.triangles.size() + 64);
  append_integer(text, mesh.positions.size());
  append_integer(text += ' ', mesh.triangles.size());
  text += " 0\n";
  for (const Vec3& p : mesh.positions) {
    append_number(text, p.x);
    append_number(text += ' ', p.y);
    append_number(text += ' ', p.z);
    text += '\n';
  }
  for (const Triangle& triangle : mesh.triangles) {
    text += '3';
    for (const Index v : triangle)
      append_integer(text += ' ', v);
    text += '\n';
  }
  return text;
}

}  // namespace planish
