#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <planish/measure/limit_check.h>

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

/// The limits of strain that a material has: those of |strain| where it gives as far in both ways,
/// else those of stretch and of compression.
StrainLimits limits_of(const Material& material);

/// Whether a material takes the strain of a pattern, and what speaks most against it: the limit of
/// which most is used up, of all that it has.
struct MaterialVerdict {
  const Material* material = nullptr;  ///< of materials()
  bool takes = false;                  ///< whether all of its limits are kept
  LimitCheck tightest = {};            ///< that limit; where is not known
};

/// One for each of materials(), in their order.
std::vector<MaterialVerdict> materials_for(const EdgeStrain& strain);

}  // namespace planish
