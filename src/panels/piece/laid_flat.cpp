#include "panels/piece/laid_flat.h"

#include <limits>
#include <utility>

namespace planish {

std::optional<LaidFlat> laid_flat(const PanelMesh& mesh, const PieceCorners& corners,
                                  const StrainLimits& limits, const Context& context) {
  TriMesh piece;
  for (std::size_t v = 0; v < corners.vertex_count(); ++v)
    piece.positions.push_back(mesh.patch().positions()[corners.vertex_of(v)]);
  piece.triangles = corners.all_corners();
  try {
    LaidFlat flat{Patch(std::move(piece)), {}, {}};
    UnfoldOptions options;
    options.least_stretch = true;
    options.limits = limits;
    // As much as unfold() moves sides of a slit apart at most.
    options.open_crossings = std::numeric_limits<double>::max();
    flat.pattern = unfold(flat.patch, options, context);
    flat.strain = edge_strain(flat.patch, flat.pattern.positions);
    return flat;
  } catch (const Error&) {
    return std::nullopt;
  }
}

}  // namespace planish
