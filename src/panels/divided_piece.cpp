#include "panels/divided_piece.h"

#include <utility>

#include <planish/mesh/imprint.h>

#include "panels/cells/divided_cells.h"

namespace planish {

CarriedSeams with_pieces_divided(const SeamNet& net, const OpenEdges& open,
                                 std::span<const std::vector<Index>> pieces, double least_area,
                                 ThreadPool& pool) {
  const Patch& patch = net.mesh.patch();
  std::vector<SurfaceLine> lines;
  std::vector<unsigned char> is_open;
  for (Index e = 0; e < open.size(); ++e) {
    if (net.seams[e] == 0) continue;
    lines.push_back(line_along_edges(patch, net.mesh.edges()[e].ends));
    is_open.push_back(open[e]);
  }
  for (const std::vector<Index>& piece : pieces) {
    for (SurfaceLine& line : dividing_lines(net.mesh, open, piece, pool)) {
      lines.push_back(std::move(line));
      is_open.push_back(1);
    }
  }
  return imprinted_seams(patch, lines, is_open, least_area);
}

}  // namespace planish
