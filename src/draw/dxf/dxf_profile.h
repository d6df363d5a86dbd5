#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <planish/draw/format_drawing.h>

namespace planish {

/// Which standard of apparel programs a file follows.
enum class DxfFamily {
  none,
  aama,  ///< ANSI/AAMA-292
  astm,  ///< ASTM D6673
};

/// How the profiles differ.
struct DxfDialect {
  DxfProfile profile;
  std::string_view name;
  DxfFamily family;
  std::string_view version = {};  ///< $ACADVER of a file with pieces; empty: its header is empty
  bool in_capitals = false;       ///< the keys of texts
  std::string_view material = "Material";  ///< the key of what a piece is cut from
};

const DxfDialect& dialect_of(DxfProfile profile);

/// Layers of apparel CAD by number.
inline constexpr std::string_view k_boundary_layer = "1";

/// The name in the file of a layer of the drawing; nothing if it is left out.
std::optional<std::string> dxf_layer_name(std::string_view layer, const DxfOptions& options);

/// @throws Error unknown_name where the options name a layer that the drawing does not have
void check_layer_names(const Drawing& drawing, const DxfOptions& options);

}  // namespace planish
