#include "panels/divided_piece.h"

#include <utility>

#include <planish/mesh/imprint.h>

#include "panels/cells/divided_cells.h"
#include "panels/piece/laid_flat.h"
#include "unfold/cuts/dividing_path.h"
#include "unfold/cuts/tight_line.h"

namespace planish {

namespace {

/// A shortest way that parts sides of the pattern which cross, on the triangles of the mesh;
/// nothing where none cross.
std::vector<SurfaceLine> unlapping_lines(const PanelMesh& mesh, const OpenEdges& open,
                                         const std::vector<Index>& piece) {
  const PieceCorners corners(mesh, open, piece);
  const Context alone{.threads = 1};
  const auto flat = laid_flat(mesh, corners, {}, alone);
  if (!flat || !flat->pattern.overlaps) return {};
  const auto path = dividing_path(flat->patch, flat->pattern.positions, {});
  if (!path) return {};
  SurfaceLine line = tight_line(flat->patch, *path, {}, alone);
  for (SurfacePoint& place : line) {
    for (Index& v : place.corners)
      v = corners.vertex_of(v);
  }
  return {std::move(line)};
}

}  // namespace

CarriedSeams with_pieces_divided(const SeamNet& net, const OpenEdges& open,
                                 std::span<const std::vector<Index>> pieces, double least_area,
                                 ThreadPool& pool) {
  const Patch& patch = net.mesh.patch();
  std::vector<SurfaceLine> lines;
  std::vector<unsigned char> is_open;
  const OpenEdges closed = net.closed(open);
  for (const bool opened : {true, false}) {
    for (const SeamChain& chain : seam_chains(net.mesh, opened ? open : closed)) {
      lines.push_back(line_along_edges(patch, chain.vertices));
      is_open.push_back(opened ? 1 : 0);
    }
  }
  for (const std::vector<Index>& piece : pieces) {
    std::vector<SurfaceLine> dividing = unlapping_lines(net.mesh, open, piece);
    if (dividing.empty()) dividing = dividing_lines(net.mesh, open, piece, pool);
    for (SurfaceLine& line : dividing) {
      lines.push_back(std::move(line));
      is_open.push_back(1);
    }
  }
  return imprinted_seams(patch, lines, is_open, least_area);
}

}  // namespace planish
