#include "report/pictures/piece_outline.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "core/number_text.h"
#include "draw/text/markup_text.h"
#include "pattern/polygon/loop_box.h"

namespace planish {

namespace {

// The window, and what is left free for the discs with numbers. Its unit is about 1.7 pixels.
constexpr double k_width = 104.0, k_height = 100.0, k_outline_margin = 8.0;
constexpr double k_disc = 5.8;      // radius
constexpr double k_nearest = 0.15;  // of two points of a line: nearer ones look like one

/// Places in the pattern to places in the window, where y points down.
class Fit {
 public:
  Fit(std::span<const Vec2> pattern, double scale) : scale_(scale) {
    const LoopBox box = box_around(pattern);
    middle_ = 0.5 * (box.low + box.high);
  }

  Vec2 operator()(Vec2 p) const {
    const Vec2 shift = scale_ * (p - middle_);
    return {0.5 * k_width + shift.x, 0.5 * k_height - shift.y};
  }

 private:
  double scale_;
  Vec2 middle_;
};

std::vector<Vec2> line_in_window(const SeamSide& side, std::span<const Vec2> pattern,
                                 const Fit& fit) {
  std::vector<Vec2> line = line_of(side, pattern);
  for (Vec2& p : line)
    p = fit(p);
  return line;
}

std::string path_of(const std::vector<Vec2>& line) {
  std::string path;
  for (std::size_t k = 0; k < line.size(); ++k) {
    path +=
        std::string(k == 0 ? "M" : " ") + fixed_text(line[k].x, 2) + " " + fixed_text(line[k].y, 2);
  }
  return path;
}

/// Without points that lie too near to the one before; both ends stay.
std::vector<Vec2> thinned(const std::vector<Vec2>& line) {
  std::vector<Vec2> kept;
  for (std::size_t k = 0; k < line.size(); ++k) {
    const bool is_end = k == 0 || k + 1 == line.size();
    if (is_end || norm(line[k] - kept.back()) >= k_nearest) kept.push_back(line[k]);
  }
  return kept;
}

/// Half way along.
Vec2 middle_of(const std::vector<Vec2>& line) {
  double left = 0.0;
  for (std::size_t k = 1; k < line.size(); ++k)
    left += 0.5 * norm(line[k] - line[k - 1]);
  for (std::size_t k = 1; k < line.size(); ++k) {
    const double length = norm(line[k] - line[k - 1]);
    if (length > 0.0 && left <= length)
      return line[k - 1] + (left / length) * (line[k] - line[k - 1]);
    left -= length;
  }
  return line.back();
}

std::string number_at(Vec2 middle, std::size_t number) {
  const std::string x = fixed_text(middle.x, 2), y = fixed_text(middle.y, 2);
  return "<circle cx=\"" + x + "\" cy=\"" + y + "\" r=\"" + fixed_text(k_disc, 1) +
         "\"/><text x=\"" + x + "\" y=\"" + y + "\" dy=\".36em\">" + std::to_string(number) +
         "</text>";
}

}  // namespace

std::string seam_class(std::size_t number) {
  // Of page.css: blue, green, orange, purple, sky, olive, red, brown.
  constexpr std::array<int, 8> lines = {1, 3, 2, 4, 6, 5, 8, 7};
  return "line-" + std::to_string(lines.at((number - 1) % lines.size()));
}

OutlineWindow::OutlineWindow(std::span<const std::vector<Vec2>> patterns) {
  Vec2 largest;
  for (const std::vector<Vec2>& pattern : patterns) {
    const Vec2 size = box_around(pattern).size();
    largest = {std::max(largest.x, size.x), std::max(largest.y, size.y)};
  }
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const double x = (k_width - 2.0 * k_outline_margin) / largest.x;
  const double y = (k_height - 2.0 * k_outline_margin) / largest.y;
  const double scale = std::min(largest.x > 0.0 ? x : infinity, largest.y > 0.0 ? y : infinity);
  if (scale < infinity) scale_ = scale;
}

std::string piece_outline(const Patch& patch, std::span<const Vec2> pattern,
                          const OutlineWindow& window, const std::string& alt,
                          std::span<const OutlinedSeam> seams) {
  const Fit fit(pattern, window.scale());
  std::string border, lines, numbers;
  for (const std::vector<Index>& loop : patch.border_loops())
    border += path_of(thinned(line_in_window({0, loop}, pattern, fit))) + "z";
  for (const OutlinedSeam& seam : seams) {
    const std::vector<Vec2> line = line_in_window(seam.side, pattern, fit);
    const std::string group = "<g class=\"" + seam_class(seam.number) + "\">";
    lines += group + "<path d=\"" + path_of(thinned(line)) + "\"/></g>";
    numbers += group + number_at(middle_of(line), seam.number) + "</g>";
  }
  return "<svg class=\"outline\" role=\"img\" aria-label=\"" + escape_markup(alt) +
         "\" viewBox=\"0 0 " + fixed_text(k_width, 0) + " " + fixed_text(k_height, 0) +
         "\"><path class=\"border\" d=\"" + border + "\"/>" + lines + numbers + "</svg>";
}

}  // namespace planish
