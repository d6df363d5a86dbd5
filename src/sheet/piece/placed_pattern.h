#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <planish/core/unit.h>
#include <planish/mesh/tri_mesh.h>
#include <planish/pattern/pattern_options.h>

namespace planish {

/// A pattern on its sheet, in millimetres there.
struct PlacedPattern {
  PieceOutline outline;
  std::vector<Polygon> cut;                ///< with the allowance; the outline's loops without
  std::vector<Vec2> positions;             ///< of all vertices
  std::vector<PlacedNotch> notches = {};   ///< on the cut line
  FittedLines fitted_cut, fitted_outline;  ///< with a point at each notch
};

/// Where the unfolding put it.
/// @param positions of all vertices in the pattern, model units
/// @param piece what messages call it
/// @throws Error as offset_outline(), with_edge_allowances(), fold_stretch() and
/// place_notches()
PlacedPattern placed_pattern(const TriMesh& mesh, std::span<const Vec2> positions, Unit unit,
                             const std::string& piece, const PatternOptions& options);

/// The same elsewhere.
/// @param motion that keeps lengths, a multiple of turns, shifts and mirroring; lines keep the
/// order
///   of their points
PlacedPattern moved(PlacedPattern pattern, const std::function<Vec2(Vec2)>& motion);

}  // namespace planish
