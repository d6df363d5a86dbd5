#include "panels/piece/laid_flat.h"

#include <array>
#include <set>
#include <utility>
#include <vector>

namespace planish {

namespace {

/// The edges of the border that have no length.
std::vector<std::array<Index, 2>> edges_without(const PieceCorners& corners,
                                                std::span<const EdgeLength> seams) {
  std::set<std::array<Index, 2>> with;
  for (const auto& [edge, length] : seams)
    with.insert({edge[1], edge[0]}), with.insert(edge);
  std::vector<std::array<Index, 2>> without;
  for (const std::vector<Index>& loop : corners.border_loops()) {
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const std::array<Index, 2> edge = {loop[k], loop[(k + 1) % loop.size()]};
      if (!with.contains(edge)) without.push_back(edge);
    }
  }
  return without;
}

}  // namespace

TriMesh cut_out(const PanelMesh& mesh, const PieceCorners& corners) {
  TriMesh piece;
  for (std::size_t v = 0; v < corners.vertex_count(); ++v)
    piece.positions.push_back(mesh.patch().positions()[corners.vertex_of(v)]);
  piece.triangles = corners.all_corners();
  return piece;
}

std::optional<LaidFlat> laid_flat(const PanelMesh& mesh, const PieceCorners& corners,
                                  const PieceLimits& limits, const Context& context,
                                  std::span<const EdgeLength> seams) {
  try {
    LaidFlat flat{Patch(cut_out(mesh, corners)), {}, {}};
    UnfoldOptions options;
    options.least_stretch = true;
    options.limits = limits.strain;
    options.max_iterations = limits.max_iterations;
    options.open_crossings = limits.open_crossings;
    if (!seams.empty()) {
      options.match_seams = options.match_if_possible = true;
      options.seam_lengths.assign(seams.begin(), seams.end());
      options.free_edges = edges_without(corners, seams);
    }
    flat.pattern = unfold(flat.patch, options, context);
    flat.strain = edge_strain(flat.patch, flat.pattern.positions);
    return flat;
  } catch (const Error&) {
    return std::nullopt;
  }
}

std::vector<FlatSide> seam_sides(const PanelMesh& mesh, const OpenEdges& open,
                                 const PieceCorners& corners, std::span<const Index> triangles,
                                 const Pattern& pattern) {
  std::vector<FlatSide> sides;
  for (std::size_t k = 0; k < triangles.size(); ++k) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Index e = mesh.edge_of(triangles[k], i);
      if (open[e] == 0 || mesh.edges()[e].is_border()) continue;
      const Index from = corners.corners(k)[i], to = corners.corners(k)[(i + 1) % 3];
      sides.push_back({e, {from, to}, norm(pattern.positions[to] - pattern.positions[from])});
    }
  }
  return sides;
}

}  // namespace planish
