#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include <planish/core/unit.h>
#include <planish/mesh/tri_mesh.h>
#include <planish/sheet/pattern_geometry.h>

namespace planish {

/// Its lines and notches where the unfolding put it, without what depends on where it lies.
/// @param positions of all vertices in the pattern, model units
/// @param piece what messages call it, and its name
/// @throws Error as offset_outline(), with_edge_allowances(), fold_stretch() and
/// place_notches()
PatternGeometry placed_pattern(const TriMesh& mesh, std::span<const Vec2> positions, Unit unit,
                               const std::string& piece, PatternOptions options);

/// The stretches that the allowance of a pattern fills.
std::vector<FilledStretch> filled_stretches(const PatternGeometry& pattern);

/// The same elsewhere.
/// @param motion that keeps lengths, a multiple of turns, shifts and mirroring; lines keep the
///   order of their points
PatternGeometry moved(PatternGeometry pattern, const std::function<Vec2(Vec2)>& motion);

}  // namespace planish
