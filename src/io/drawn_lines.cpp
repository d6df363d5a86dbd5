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
