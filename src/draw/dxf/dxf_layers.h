#pragma once

#include <string>
#include <vector>

#include <planish/draw/color.h>

#include "draw/dxf/dxf_tags.h"

namespace planish {

/// A layer as the table of layers has it.
struct DxfLayer {
  std::string name;
  int color = 7;  ///< number in AutoCAD's table
  bool visible = true;
};

/// The layers that have entities. Each has the colour of its first.
class DxfLayers {
 public:
  /// The tags of how an entity looks on a layer, where the layer looks otherwise.
  /// @param visible whether it shows: a layer does if one of its entities does
  DxfTags looks_on(const std::string& layer, Color color, bool dashed, bool visible);

  /// In the order of their first entities, behind layer 0, which every file has.
  std::vector<DxfLayer> with_layer_0() const;

 private:
  std::vector<DxfLayer> layers_;
};

}  // namespace planish
