#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <planish/draw/drawing.h>

#include "draw/dxf/dxf_tags.h"

namespace planish {

/// A layer as the table of layers tells it.
struct DxfLayer {
  std::string name;
  int color = 7;  ///< number in AutoCAD's table
  bool visible = true;
};

/// Turns shapes into entities, and collects what tables and header must say of them.
class DxfEntities {
 public:
  /// @param numbered layers are those of apparel CAD: of a closed path on the boundary's layer with
  ///   several lines, the largest is the boundary and the others are cut-outs
  explicit DxfEntities(bool numbered) : numbered_(numbered) {}

  void add(const Layer& layer, const std::string& name);

  /// The entities of each piece.
  const std::map<std::size_t, DxfTags>& pieces() const { return pieces_; }
  /// All layers that have entities, in the order of their first.
  const std::vector<DxfLayer>& layers() const { return layers_; }
  /// The corners of the box around all of a piece; nothing of pieces without points.
  std::optional<std::pair<Vec2, Vec2>> box_of(std::size_t piece) const;
  std::optional<std::pair<Vec2, Vec2>> box() const;

 private:
  void add(const Path& path, const std::string& layer, bool visible);
  void add(const Text& text, const std::string& layer, bool visible);
  void add_polyline(DxfTags& tags, const std::vector<Vec2>& places, const DxfTags& looks,
                    const std::string& layer, bool closed);
  DxfTags looks_on(const std::string& layer, Color color, bool dashed, bool visible);
  void stretch_box(std::size_t piece, Vec2 point);

  bool numbered_;
  std::map<std::size_t, DxfTags> pieces_;
  std::map<std::size_t, std::pair<Vec2, Vec2>> boxes_;
  std::vector<DxfLayer> layers_;
};

}  // namespace planish
