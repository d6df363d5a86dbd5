#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace planish {

/// One figure of a material, and where it comes from.
struct MaterialFigure {
  double strain = 0.0;  ///< a share of the length on the form, above 0 and at most 1: 0.01 is 1 %
  std::string source = {};  ///< what was measured, and where that is written; one line
};

/// How far a sheet gives in one way.
struct MaterialLimit {
  MaterialFigure usual = {};                   ///< on 99 % of the area
  std::optional<MaterialFigure> largest = {};  ///< anywhere, at least `usual`; nothing: not known
};

/// What a pattern is cut from, by how far it may be stretched and compressed on its way into the
/// form. Both are shares of the length on the form, as all strain of patterns is.
struct Material {
  std::string name = {};           ///< as `--material` takes it
  std::string use = {};            ///< for which sheet and work the figures are, one line
  MaterialLimit stretch = {};      ///< where the pattern is shorter than the form
  MaterialLimit compression = {};  ///< where it is longer: pressed together, or eased in
};

/// All named materials, by their stretch, the least first. Guide values, to be replaced by a test
/// of the sheet at hand (docs/materials.md).
std::span<const Material> materials();

/// @throws Error unknown_name naming the materials that are known
const Material& material_named(std::string_view name);

/// Their names, in the order of materials().
std::vector<std::string> material_names();

}  // namespace planish
