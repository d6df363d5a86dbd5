#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <planish/core/vec.h>
#include <planish/draw/color.h>
#include <planish/pattern/curve.h>
#include <planish/pattern/notches.h>

namespace planish {

/// A line's looks. Width in millimetres.
struct Stroke {
  Color color;          ///< of the line
  double width = 0.25;  ///< millimetres, above 0
  bool dashed = false;  ///< in dashes instead of solid
};

/// The strokes of a path are a notch.
struct NotchMark {
  Vec2 at;                           ///< on the line that is cut, millimetres
  double angle = 0.0;                ///< into the piece: degrees, counter-clockwise from the x axis
  double depth = 0.0;                ///< millimetres
  double width = 0.0;                ///< of a V at the edge, of a T's bar; 0 of a slit; millimetres
  NotchKind kind = NotchKind::slit;  ///< its form
};

/// The strokes of a path are a match mark or a drill hole.
struct DrillMark {
  Vec2 at;  ///< millimetres
};

/// The strokes of a path are the grain line.
struct GrainMark {
  Vec2 from, to;  ///< its ends, millimetres
};

/// The strokes of a path are the line along which the material is folded.
struct FoldMark {
  Vec2 from, to;        ///< its ends, millimetres
  bool opened = false;  ///< the piece is drawn whole, not its half
};

/// The strokes of a path are for people, as the bracket beside a fold. Formats that have entities
/// for the others leave it out.
struct SignMark {};

/// What a path stands for. Formats that have an entity for it write that; in all others its strokes
/// are drawn.
using PieceMark = std::variant<std::monostate, NotchMark, DrillMark, GrainMark, FoldMark, SignMark>;

/// One or more polylines as one thing: an outline, or with a fill the area inside them (even-odd).
struct Path {
  std::vector<std::vector<Vec2>> lines;  ///< points of each polyline, millimetres
  bool closed = false;                   ///< each line returns from its last point to its first
  std::optional<Stroke> stroke = {};     ///< none: no outline is drawn
  std::optional<Color> fill = {};        ///< none: nothing is filled
  std::size_t piece = 0;                 ///< that it belongs to, see Drawing::pieces
  PieceMark mark = {};                   ///< what the path stands for
  FittedLines fitted = {};               ///< what may be drawn instead of the lines
};

/// One line of UTF-8 text. `at` is the left (or middle) end of its baseline.
struct Text {
  Vec2 at;                ///< millimetres
  double height = 4.0;    ///< of capital letters' line, millimetres
  std::string text;       ///< UTF-8, one line
  Color color = {};       ///< of the letters
  bool centred = false;   ///< `at` is the middle of the line, else its left end
  std::size_t piece = 0;  ///< that it belongs to, see Drawing::pieces
};

/// What a layer consists of.
using DrawingShape = std::variant<Path, Text>;

/// Shapes with one meaning, to be shown, hidden or sent to a tool together.
struct Layer {
  std::string name;                  ///< UTF-8, as in k_sheet_layers
  std::vector<DrawingShape> shapes;  ///< in the order in which they are drawn
  bool visible = true;               ///< false: written, but hidden at first
};

/// What formats that know pieces write of one.
struct DrawingPiece {
  std::string name;           ///< empty: the drawing's title
  std::string size = {};      ///< as "40"; empty: none is given
  int quantity = 1;           ///< how many are to be cut as drawn
  int mirrored = 0;           ///< how many more as mirror images
  std::string material = {};  ///< that it is cut from; empty: none is given
  std::string note = {};      ///< as "one mirrored"; empty: none is given
};

/// A sheet in millimetres: x to the right, y up, (0, 0) at the lower left. What every writer of
/// pattern files consumes. Layers are drawn in order.
struct Drawing {
  std::string title;                 ///< UTF-8; what viewers show as the name of the file
  double width = 0.0, height = 0.0;  ///< of the sheet, millimetres
  std::vector<Layer> layers;         ///< the first one lies below all others
  /// The pieces on the sheet by number. One that is missing goes by the title, once, in no size.
  std::vector<DrawingPiece> pieces = {};
  std::string date = {};  ///< for formats that have a place for it; empty: none
  /// What the layer "label" says of the pieces, for formats that lay out words themselves.
  std::vector<std::string> notes = {};
};

}  // namespace planish
