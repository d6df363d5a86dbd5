#include "io/read_drawing.h"

#include <cstddef>
#include <utility>

#include "core/number_text.h"
#include "io/drawn_lines.h"
#include "io/file/append.h"
#include "io/file/file_bytes.h"
#include "io/file/text_cursor.h"
#include "platform/path.h"

namespace planish {

namespace {

/// Appends a statement of the numbers of the last vertices, from 1; a closed one ends in its first.
void append_statement(char keyword, std::size_t first, std::size_t count, bool closed,
                      std::string& text) {
  text += keyword;
  for (std::size_t i = 0; i < count; ++i) {
    text += ' ';
    append_integer(text, first + i);
  }
  if (closed) {
    text += ' ';
    append_integer(text, first);
  }
  text += '\n';
}

void append_vertex(Vec3 p, std::string& text) {
  text += 'v';
  for (const double x : {p.x, p.y, p.z}) {
    text += ' ';
    append_number(text, x);
  }
  text += '\n';
}

}  // namespace

DrawnLines read_obj_lines(const std::filesystem::path& path) {
  const FileBytes file(path);
  return parse_obj_lines(file.view(), utf8_of(path));
}

DrawnLines parse_obj_lines(std::string_view bytes, const std::string& name) {
  TextCursor cursor(bytes, name, {.comments = true, .continuation = true});
  const LineDrawing drawing = parse_line_drawing(cursor);
  DrawnLines drawn;
  std::size_t done = 0;
  const auto take_points = [&](std::size_t end) {
    for (; done < end; ++done)
      drawn.points.push_back(drawing.places[drawing.corners[done]]);
  };
  for (const LineDrawing::Line& line : drawing.lines) {
    take_points(line.begin);
    DrawnLine& some = drawn.lines.emplace_back(DrawnLine{{}, {.path = name, .line = line.line}});
    for (; done < line.end; ++done)
      some.points.push_back(drawing.places[drawing.corners[done]]);
  }
  take_points(drawing.corners.size());
  return drawn;
}

std::string format_obj_lines(const DrawnLines& drawn) {
  std::string text;
  std::size_t vertices = 0;
  for (const DrawnLine& line : drawn.lines) {
    const bool closed = line.points.size() > 2 && line.points.front() == line.points.back();
    const std::size_t count = line.points.size() - (closed ? 1 : 0);
    for (std::size_t i = 0; i < count; ++i)
      append_vertex(line.points[i], text);
    append_statement('l', vertices + 1, count, closed, text);
    vertices += count;
  }
  for (const Vec3 p : drawn.points) {
    append_vertex(p, text);
    append_statement('p', ++vertices, 1, false, text);
  }
  return text;
}

SvgDrawing read_svg(const std::filesystem::path& path, std::span<const std::string_view> layers) {
  const FileBytes file(path);
  return parse_svg(file.view(), utf8_of(path), layers);
}

}  // namespace planish
