#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "io/file/append.h"
#include "io/file/byte_cursor.h"
#include "io/file/file_type_sniffer.h"
#include "io/file/text_cursor.h"
#include "io/formats/face_list.h"
#include "io/formats/formats.h"
#include "io/formats/welder.h"

namespace planish {
namespace {

constexpr std::size_t k_header_bytes = 80;
constexpr std::size_t k_first_facet = 84;
constexpr std::size_t k_facet_bytes = 50;

bool equal_ignoring_case(std::string_view word, std::string_view lower) {
  return std::equal(word.begin(), word.end(), lower.begin(), lower.end(), [](char a, char b) {
    return (a >= 'A' && a <= 'Z' ? static_cast<char>(a - 'A' + 'a') : a) == b;
  });
}

/// Collects facets and gives corners at one place one number.
class FacetList {
 public:
  explicit FacetList(bool strict) : faces_(strict) {}

  template <class Cursor>
  Index corner(Vec3 position, const Cursor& cursor) {
    const Index vertex = welder_.vertex(position);
    check_size(welder_.size(), "vertices", cursor);
    return vertex;
  }

  template <class Cursor>
  void add(const Triangle& triangle, const Cursor& cursor) {
    faces_.add(triangle, cursor);
  }

  std::size_t size() const { return faces_.size(); }

  template <class Cursor>
  ReadResult take(const Cursor& cursor) {
    std::string note = "welded " + std::to_string(3 * faces_.size()) + " corners to " +
                       std::to_string(welder_.size()) +
                       " vertices: STL has no vertex numbers, so an open seam would be closed too";
    std::vector<Vec3> positions = welder_.take();
    std::vector<Triangle> triangles = faces_.take(positions, cursor);
    return {.mesh = {std::move(positions), std::move(triangles)},
            .format = MeshFormat::stl,
            .notes = {std::move(note)}};
  }

 private:
  Welder welder_;
  FaceList faces_;
};

class AsciiStlParser {
 public:
  AsciiStlParser(std::string_view bytes, std::string_view name, const ReadOptions& options)
      : cursor_(bytes, name), strict_(options.strict), facets_(options.strict) {}

  ReadResult parse() {
    bool open = false, begun = false;
    for (; cursor_.skip_to_token(); begun = true) {
      const std::string_view word = cursor_.token();
      if (equal_ignoring_case(word, "facet")) {
        facet();
        continue;
      }
      open = equal_ignoring_case(word, "solid");
      if (!open && !is_end_of("solid", word)) fail_expected(begun ? "facet" : "solid", word);
      cursor_.next_line();  // a name, of any bytes
    }
    cursor_.begin_item({}, 0);
    if (open || facets_.size() == 0) finish(open);
    ReadResult result = facets_.take(cursor_);
    if (in_two_words_ > 0) {
      result.notes.push_back("took \"end\" and the word behind it for one word, " +
                             std::to_string(in_two_words_) +
                             (in_two_words_ == 1 ? " time" : " times"));
    }
    return result;
  }

 private:
  void finish(bool open) const {
    if (open) cursor_.fail(ErrorCode::truncated_file, "the file ends without endsolid");
    cursor_.fail(ErrorCode::no_triangles, "the file has no facets");
  }

  void facet() {
    cursor_.begin_item("facet", facets_.size());
    expect("normal");
    // Some writers put "nan" or "-1.#IND" here: normals follow from the corners.
    for (int i = 0; i < 3; ++i)
      next_word("a number");
    expect("outer");
    expect("loop");
    Triangle triangle = {corner(), corner(), corner()};
    expect_end_of("loop");
    expect_end_of("facet");
    facets_.add(triangle, cursor_);
  }

  Index corner() {
    expect("vertex");
    std::array<double, 3> c = {};
    for (double& coordinate : c) {
      cursor_.skip_to_token();
      coordinate = cursor_.number();
    }
    return facets_.corner({c[0], c[1], c[2]}, cursor_);
  }

  std::string_view next_word(const std::string& what) {
    if (!cursor_.skip_to_token()) cursor_.fail_missing(what);
    return cursor_.token();
  }

  void expect(const std::string& word) {
    const std::string_view found = next_word(in_quotes(word));
    if (!equal_ignoring_case(found, word)) fail_expected(word, found);
  }

  void expect_end_of(const std::string& block) {
    const std::string_view found = next_word(in_quotes("end" + block));
    if (!is_end_of(block, found)) fail_expected("end" + block, found);
  }

  /// Whether a word ends a block, as endsolid does; some writers make two words of it.
  bool is_end_of(std::string_view block, std::string_view found) {
    if (equal_ignoring_case(found, "end") && !strict_) {
      ++in_two_words_;
      return equal_ignoring_case(next_word(in_quotes(block)), block);
    }
    return found.size() == 3 + block.size() && equal_ignoring_case(found.substr(0, 3), "end") &&
           equal_ignoring_case(found.substr(3), block);
  }

  [[noreturn]] void fail_expected(std::string_view word, std::string_view found) const {
    cursor_.fail(ErrorCode::malformed_file,
                 "expected " + in_quotes(word) + ", found " + in_quotes(found));
  }

  TextCursor cursor_;
  bool strict_;
  FacetList facets_;
  std::size_t in_two_words_ = 0;
};

std::uint32_t announced_facets(std::string_view bytes, std::string_view name) {
  return ByteCursor(bytes, name, k_header_bytes).value<std::uint32_t>(std::endian::little);
}

/// Whether the file is as long as its count of facets says: then it is binary, whatever it begins
/// with.
bool has_size_of_binary(std::string_view bytes, std::string_view name) {
  return bytes.size() >= k_first_facet &&
         bytes.size() ==
             k_first_facet + k_facet_bytes * std::uint64_t{announced_facets(bytes, name)};
}

/// Whether the place of the count, or all of a shorter file, is printable: as a count, such
/// characters would be hundreds of millions.
bool has_text_for_count(std::string_view bytes) {
  const std::string_view place =
      bytes.size() < k_first_facet ? bytes : bytes.substr(k_header_bytes, sizeof(std::uint32_t));
  return std::all_of(place.begin(), place.end(),
                     [](char c) { return (c >= ' ' && c <= '~') || (c >= '\t' && c <= '\r'); });
}

/// Headers of binary files may begin with "solid" too. Then a zero byte near the front tells.
bool is_binary(std::string_view bytes, std::string_view name) {
  if (has_text_for_count(bytes)) return false;
  constexpr std::size_t k_front = 1024;
  if (bytes.substr(0, k_front).find('\0') != std::string_view::npos) return true;
  TextCursor cursor(bytes.substr(0, k_front), name);
  return !cursor.skip_to_token() || !equal_ignoring_case(cursor.token(), "solid");
}

Index binary_corner(ByteCursor& cursor, FacetList& facets) {
  std::array<double, 3> c = {};
  for (double& coordinate : c) {
    coordinate = static_cast<double>(cursor.value<float>(std::endian::little));
    if (!std::isfinite(coordinate)) {
      cursor.fail(ErrorCode::non_finite_coordinate,
                  "a coordinate is " + std::to_string(coordinate));
    }
  }
  return facets.corner({c[0], c[1], c[2]}, cursor);
}

/// A count that is too small would lose facets without a word.
void check_rest(std::uint32_t count, std::size_t rest, const ByteCursor& cursor) {
  if (rest == 0 || rest % k_facet_bytes != 0) return;
  cursor.fail(ErrorCode::malformed_file, "the file announces " + std::to_string(count) +
                                             " facets but has " +
                                             std::to_string(count + rest / k_facet_bytes));
}

ReadResult parse_binary(std::string_view bytes, std::string_view name, const ReadOptions& options) {
  if (bytes.size() < k_first_facet) {
    ByteCursor(bytes, name, 0)
        .fail(ErrorCode::truncated_file,
              "an STL file has at least 84 bytes, this one has " + std::to_string(bytes.size()));
  }
  const std::uint32_t count = announced_facets(bytes, name);
  ByteCursor cursor(bytes, name, k_first_facet);
  if (count > cursor.remaining() / k_facet_bytes) {
    cursor.fail(ErrorCode::truncated_file, "the file announces " + std::to_string(count) +
                                               " facets but has room for " +
                                               std::to_string(cursor.remaining() / k_facet_bytes));
  }
  if (count == 0) cursor.fail(ErrorCode::no_triangles, "the file has no facets");
  FacetList facets(options.strict);
  for (std::uint32_t i = 0; i < count; ++i) {
    cursor.begin_item("facet", i);
    cursor.skip(3 * sizeof(float));  // the normal
    // Braces keep the order of the calls.
    const Triangle triangle = {binary_corner(cursor, facets), binary_corner(cursor, facets),
                               binary_corner(cursor, facets)};
    cursor.skip(2);  // the attribute, in use for colours
    facets.add(triangle, cursor);
  }
  const std::size_t rest = cursor.remaining();
  cursor.begin_item({}, 0);
  check_rest(count, rest, cursor);
  ReadResult result = facets.take(cursor);
  if (rest > 0) {
    result.notes.push_back("ignored " + std::to_string(rest) + " bytes after the last facet");
  }
  return result;
}

/// The unit normal, or 0 where there is none.
Vec3 unit_normal(Vec3 a, Vec3 b, Vec3 c) {
  const Vec3 u = b - a;
  const Vec3 v = c - a;
  double largest = 0.0;
  for (const double d : {u.x, u.y, u.z, v.x, v.y, v.z})
    largest = std::max(largest, std::abs(d));
  // Scaled, squares can neither overflow nor vanish. What is smaller is no float but 0.
  if (largest < 1e-300) return {};
  const Vec3 n = cross((1.0 / largest) * u, (1.0 / largest) * v);
  const double length = norm(n);
  return length > 0.0 ? (1.0 / length) * n : Vec3{};
}

}  // namespace

ReadResult parse_stl(std::string_view bytes, std::string_view name, const ReadOptions& options) {
  if (has_size_of_binary(bytes, name)) return parse_binary(bytes, name, options);
  refuse_foreign(bytes, name);
  const bool binary = wide_encoding(bytes).empty() && is_binary(bytes, name);
  return binary ? parse_binary(bytes, name, options) : AsciiStlParser(bytes, name, options).parse();
}

std::string format_stl(const TriMesh& mesh) {
  std::string bytes = "Planish: binary STL";  // must not begin with "solid"
  bytes.reserve(k_first_facet + k_facet_bytes * mesh.triangles.size());
  bytes.resize(k_header_bytes, ' ');
  append_little_endian(bytes, static_cast<std::uint32_t>(mesh.triangles.size()));
  for (const auto& [a, b, c] : mesh.triangles) {
    const std::array<Vec3, 3> corners = {mesh.positions[a], mesh.positions[b], mesh.positions[c]};
    for (const Vec3 p :
         {unit_normal(corners[0], corners[1], corners[2]), corners[0], corners[1], corners[2]}) {
      for (const double d : {p.x, p.y, p.z})
        append_little_endian(bytes, static_cast<float>(d));
    }
    append_little_endian(bytes, std::uint16_t{0});
  }
  return bytes;
}

}  // namespace planish
