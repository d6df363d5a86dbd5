#pragma once

#include <algorithm>
#include <string>

#include <planish/draw/drawing.h>

namespace planish {

/// The layer of this name, which the drawing has.
inline const Layer& layer_of(const Drawing& drawing, const std::string& name) {
  return *std::find_if(drawing.layers.begin(), drawing.layers.end(),
                       [&](const Layer& layer) { return layer.name == name; });
}

}  // namespace planish
