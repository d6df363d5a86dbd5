#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <planish/core/unit.h>
#include <planish/draw/drawing.h>
#include <planish/flatten/product.h>
#include <planish/mesh/seams.h>
#include <planish/pattern/pattern_options.h>

namespace planish {

/// A patch of a product laid flat.
struct ProductPiece {
  std::string name;           ///< written above it
  TriMesh mesh;               ///< that was laid flat
  std::vector<Vec2> pattern;  ///< model units; empty where the patch has none: then it is left out
  std::optional<PatchTwin> twin = {};  ///< whose places the pattern has, by vertices as drawn
};

/// All pieces of a product side by side at true size in rows, the highest first, each under its
/// name. Layers: "seam" (along the borders what is sewn together, each seam in one colour, with its
/// number, from 1, at the middle of each side), "label" (names, and whose twin a piece is) and
/// "cut" (the borders). What is written of twins in thousandths of a millimetre is mirrored digit
/// by digit.
/// @param seams of the pieces, by their numbers
Drawing product_sheet(std::span<const ProductPiece> pieces, std::span<const Seam> seams, Unit unit,
                      const std::string& title);

/// The same of what became of a product; patches that are not finished are left out.
Drawing product_sheet(const ProductReport& report, const std::string& title);

/// The options of a twin's own pattern, which is drawn as that of the other one.
/// @param of the other one's mesh
PatternOptions annotations_of_twin(PatternOptions own, const TriMesh& of, const PatchTwin& twin);

}  // namespace planish
