#pragma once

#include <span>
#include <string>

#include <planish/draw/drawing.h>

namespace planish {

/// The groups of these layers as they stand inside an <svg> element: for a file, or inside a page
/// of HTML. @param height of the sheet, as SVG counts y downwards from its upper edge
std::string svg_layers(std::span<const Layer> layers, double height);

/// "#rrggbb".
std::string hex_text(Color color);

}  // namespace planish
