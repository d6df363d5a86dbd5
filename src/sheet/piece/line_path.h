#pragma once

#include <cstddef>
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

/// The fitted lines but for one.
inline FittedLines without_line(FittedLines fitted, std::size_t number) {
  const auto at = static_cast<std::ptrdiff_t>(number);
  if (number < fitted.few.size()) fitted.few.erase(fitted.few.begin() + at);
  if (number < fitted.curves.size()) fitted.curves.erase(fitted.curves.begin() + at);
  return fitted;
}

}  // namespace planish
