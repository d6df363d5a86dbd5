#pragma once

#include <optional>
#include <string>
#include <utility>

#include <planish/draw/drawing.h>

#include "draw/dxf/dxf_layers.h"
#include "draw/dxf/dxf_places.h"
#include "draw/dxf/dxf_tags.h"

namespace planish {

/// Turns shapes into entities of R12, and collects what tables and header must say of them.
class DxfEntities {
 public:
  void add(const Layer& layer, const std::string& name);

  const DxfTags& tags() const { return tags_; }
  const DxfLayers& layers() const { return layers_; }
  /// Two corners of the box around all; nothing where there is nothing.
  const std::optional<std::pair<Vec2, Vec2>>& box() const { return box_.corners(); }

 private:
  void add(const Path& path, const std::string& layer, bool visible);
  void add(const Text& text, const std::string& layer, bool visible);

  DxfTags tags_;
  DxfBox box_;
  DxfLayers layers_;
};

}  // namespace planish
