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

/// What formats that know pieces tell of one.
struct DrawingPiece {
  std::string name;  ///< empty: the drawing's title
  std::string size = {};
  int quantity = 1;
};

/// A sheet in millimetres: x to the right, y up, (0, 0) at the lower left. What every writer of
/// pattern files consumes. Layers are drawn in order.
struct Drawing {
  std::string title;
  double width = 0.0, height = 0.0;
  std::vector<Layer> layers;
  /// The pieces on the sheet by number. One that is missing goes by the title, once, in no size.
  std::vector<DrawingPiece> pieces = {};
};

}  // namespace planish
