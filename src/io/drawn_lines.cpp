#include "io/drawn_lines.h"

#include <charconv>
#include <cstdint>
#include <string>

#include <planish/core/error.h>

#include "core/math.h"
#include "core/number_text.h"
#include "io/formats/face_list.h"
#include "io/formats/obj_references.h"

namespace planish {

Index vertex_named(std::string_view word, std::size_t vertex_count, const TextCursor& cursor) {
  std::uint64_t number = 0;
  const char* const last = word.data() + word.size();
  const auto parsed = std::from_chars(word.data(), last, number);
  if (parsed.ptr != last || parsed.ec == std::errc::invalid_argument) {
    cursor.fail(ErrorCode::bad_number,
                in_quotes(word) + " is not the number of a vertex, counted from 0");
  }
  if (parsed.ec != std::errc() || number >= vertex_count) {
    cursor.fail(ErrorCode::index_out_of_range,
                "there is no vertex " + std::string(word.substr(0, 20)) + ": the mesh has " +
                    std::to_string(vertex_count) + " vertices, counted from 0");
  }
  return static_cast<Index>(number);
}

LineDrawing parse_line_drawing(TextCursor& cursor) {
  LineDrawing drawing;
  ObjReferences references;
  const auto corners = [&](std::string_view element) {
    const std::size_t begin = drawing.corners.size();
    while (!cursor.at_line_end()) {
      drawing.corners.push_back(
          references.vertex(cursor.token(), element, drawing.places.size(), cursor));
      drawing.line_of_corner.push_back(cursor.line());
    }
    return drawing.corners.size() - begin;
  };
  for (; !cursor.at_end(); cursor.next_line()) {
    const std::string_view keyword = cursor.token();
    if (keyword == "v") {
      const double x = cursor.number(), y = cursor.number(), z = cursor.number();
      drawing.places.push_back({x, y, z});
      check_size(drawing.places.size(), "vertices", cursor);
    } else if (keyword == "p") {
      if (corners("point") == 0) cursor.fail_missing("the number of a vertex");
    } else if (keyword == "l") {
      const std::size_t line = cursor.line(), begin = drawing.corners.size();
      if (corners("line") < 2) cursor.fail(ErrorCode::malformed_file, "a line needs two vertices");
      drawing.lines.push_back({begin, drawing.corners.size(), line});
    }
  }
  references.check(drawing.places.size(), cursor);
  if (drawing.corners.empty()) {
    cursor.fail_at_line(1, ErrorCode::malformed_file,
                        "the file draws nothing: it has no lines (l) and no points (p)");
  }
  return drawing;
}

double distance_of(Vec3 a, Vec3 b) {
  return math::hypot(a.x - b.x, a.y - b.y, a.z - b.z);
}

std::string point_text(Vec3 p) {
  return "(" + number_text(p.x) + ", " + number_text(p.y) + ", " + number_text(p.z) + ")";
}

}  // namespace planish
