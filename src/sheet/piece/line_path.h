#pragma once

#include <utility>
#include <vector>

#include <planish/draw/drawing.h>

namespace planish {

/// A line as a path: one that ends in its first point is closed there.
inline Path line_path(std::vector<Vec2> line, const Stroke& stroke) {
  const bool closed = line.size() > 3 && line.front() == line.back();
  if (closed) line.pop_back();
  return Path{{std::move(line)}, closed, stroke};
}

}  // namespace planish
