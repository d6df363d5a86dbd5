#pragma once

#include <span>
#include <string_view>

namespace planish {

/// What a pattern is cut from, by how far it may be stretched or squeezed.
struct Material {
  std::string_view name;    ///< as `--material` takes it
  double max_strain;        ///< largest |strain| that it takes up, a fraction: 0.01 is 1 %
  std::string_view source;  ///< where that figure comes from, one line
};

/// All named materials, stiffest first. Guide values, to be replaced by a test of the sheet at hand
/// (docs/materials.md).
std::span<const Material> materials();

/// @throws Error unknown_name naming the materials that are known
const Material& material_named(std::string_view name);

}  // namespace planish
