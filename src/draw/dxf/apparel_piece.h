#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <planish/draw/format_drawing.h>

#include "draw/dxf/dxf_places.h"
#include "draw/dxf/dxf_tags.h"

namespace planish {

/// The entities of one piece as apparel programs read them: points for notches, drill holes and
/// the vertices of lines, single lines for grain and fold. Layers are numbered as in ANSI/AAMA-292
/// and ASTM D6673.
class ApparelPiece {
 public:
  explicit ApparelPiece(const DxfOptions& options);

  void add(const Layer& layer, const Path& path);
  /// Of a layer that has another name in the file; those of all others are in the piece's texts.
  void add(const Layer& layer, const Text& text);

  const DxfTags& tags() const { return tags_; }
  /// Two corners of the box around all of it; nothing where there is nothing.
  const std::optional<std::pair<Vec2, Vec2>>& box() const { return box_.corners(); }

 private:
  void add_outline(const Layer& layer, const Path& path, const std::string& number);
  void add_line(const std::string& layer, const std::vector<Vec2>& places, bool closed);
  void add_corner_points(const std::vector<Vec2>& places, bool closed);
  void add_notch(const std::string& number, const NotchMark& notch);
  void add_straight(const std::string& layer, Vec2 from, Vec2 to);

  const DxfOptions& options_;
  bool is_astm_;
  bool has_boundary_ = false;  // what is cut after it are holes
  DxfTags tags_;
  DxfBox box_;
};

}  // namespace planish
