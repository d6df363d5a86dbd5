#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <planish/core/vec.h>
#include <planish/draw/color.h>

namespace planish {

/// A line's looks. Width in millimetres.
struct Stroke {
  Color color;
  double width = 0.25;
  bool dashed = false;
};

/// One or more polylines as one thing: an outline, or with a fill the area inside them (even-odd).
struct Path {
  std::vector<std::vector<Vec2>> lines;
  bool closed = false;
  std::optional<Stroke> stroke = {};
  std::optional<Color> fill = {};
  std::size_t piece = 0;  ///< that it belongs to, see Drawing::pieces
};

/// One line of UTF-8 text. `at` is the left (or middle) end of its baseline.
struct Text {
  Vec2 at;
  double height = 4.0;  ///< of capital letters' line, millimetres
  std::string text;
  Color color = {};
  bool centred = false;
  std::size_t piece = 0;  ///< that it belongs to, see Drawing::pieces
};

using DrawingShape = std::variant<Path, Text>;

/// Shapes with one meaning, to be shown, hidden or sent to a tool together.
struct Layer {
  std::string name;
  std::vector<DrawingShape> shapes;
  bool visible = true;
};

/// A sheet in millimetres: x to the right, y up, (0, 0) at the lower left. What every writer of
/// pattern files consumes. Layers are drawn in order.
struct Drawing {
  std::string title;
  double width = 0.0, height = 0.0;
  std::vector<Layer> layers;
  /// Names of the pieces on the sheet, for formats that know pieces. A piece without a name here
  /// goes by the title.
  std::vector<std::string> pieces = {};
};

}  // namespace planish
