#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <planish/draw/drawing.h>

#include "draw/dxf/dxf_places.h"
#include "draw/dxf/dxf_tags.h"

namespace planish {

/// A layer as the table of layers has it.
struct DxfLayer {
  std::string name;
  int color = 7;  ///< number in AutoCAD's table
  bool visible = true;
};

/// The nearest of AutoCAD's first nine colours, by number from 1.
int color_number(Color color);

/// Turns shapes into entities of R12, and collects what tables and header must say of them.
class DxfEntities {
 public:
  void add(const Layer& layer, const std::string& name);

  /// Piece by piece.
  DxfTags tags() const;
  /// All layers that have entities, in the order of their first.
  const std::vector<DxfLayer>& layers() const { return layers_; }
  /// Two corners of the box around all; nothing where there is nothing.
  const std::optional<std::pair<Vec2, Vec2>>& box() const { return box_.corners(); }

 private:
  void add(const Path& path, const std::string& layer, bool visible);
  void add(const Text& text, const std::string& layer, bool visible);
  DxfTags looks_on(const std::string& layer, Color color, bool dashed, bool visible);

  std::map<std::size_t, DxfTags> pieces_;
  DxfBox box_;
  std::vector<DxfLayer> layers_;
};

}  // namespace planish
