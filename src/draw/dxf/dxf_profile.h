#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <planish/draw/format_drawing.h>

namespace planish {

/// What tells one profile from another.
struct DxfDialect {
  DxfProfile profile;
  std::string_view name;
  std::string_view version;  ///< $ACADVER
  bool has_pieces;           ///< blocks, numbered layers and the texts of apparel CAD
  std::string_view norm;     ///< that the style's text names; empty for none
};

const DxfDialect& dialect_of(DxfProfile profile);

/// Layers of apparel CAD by number.
inline constexpr std::string_view k_boundary_layer = "1";
inline constexpr std::string_view k_cutout_layer = "11";

/// For each layer of the drawing its name in the file; nothing for those to be left out.
/// @throws Error unknown_name where the options name a layer that the drawing has not
std::vector<std::optional<std::string>> dxf_layer_names(const Drawing& drawing,
                                                        const DxfOptions& options);

}  // namespace planish
