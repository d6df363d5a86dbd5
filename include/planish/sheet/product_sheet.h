#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <planish/core/unit.h>
#include <planish/draw/drawing.h>
#include <planish/mesh/seams.h>

namespace planish {

/// Whose places a pattern has, mirrored or not, and which vertices correspond.
struct PieceTwin {
  std::size_t piece = 0;      ///< number of the other one, whose pattern is there
  bool mirrored = false;      ///< else it is a copy
  std::vector<Index> vertex;  ///< of the other one -> of this one, both as they are drawn
};

/// A patch of a product laid flat.
struct ProductPiece {
  std::string name;           ///< written above it
  TriMesh mesh;               ///< that was laid flat
  std::vector<Vec2> pattern;  ///< model units; empty where the patch has none: then it is left out
  std::optional<PieceTwin> twin = {};  ///< whose pattern it has; none: its own
};

/// All pieces of a product side by side at true size in rows, the highest first, each under its
/// name. Layers: "cut" (the borders), "seam" (along the borders what is sewn together, each seam in
/// one colour) and "label" (names, and whose twin a piece is; at the middle of each side of a seam
/// its number, from 1). What is written of twins in thousandths of a millimetre is mirrored digit
/// by digit.
/// @param seams of the pieces, by their numbers
Drawing product_sheet(std::span<const ProductPiece> pieces, std::span<const Seam> seams, Unit unit,
                      const std::string& title);

}  // namespace planish
