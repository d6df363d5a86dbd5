#pragma once

#include <span>
#include <vector>

#include <planish/draw/drawing.h>
#include <planish/report/pattern_options.h>

namespace planish {

/// A pattern on its sheet, in millimetres there.
struct PlacedPattern {
  PieceOutline outline;
  std::vector<Polygon> cut;     ///< with the allowance; the outline's loops without
  std::vector<Vec2> positions;  ///< of all vertices
};

/// The layers seam, notch, grain, drill and annotation, in that order; what was not asked for is
/// empty.
/// @throws Error as notch_lines(), grain_direction() and mark_lines()
std::vector<Layer> furniture_layers(const TriMesh& mesh, const PlacedPattern& pattern,
                                    const PatternOptions& options);

}  // namespace planish
