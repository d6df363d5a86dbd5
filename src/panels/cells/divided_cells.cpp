#include "panels/cells/divided_cells.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "panels/cells/normal_cells.h"
#include "panels/cells/tie_lines.h"
#include "panels/piece/piece_corners.h"
#include "panels/piece/piece_strain.h"

namespace planish {

namespace {

constexpr std::size_t k_least_triangles = 8;
constexpr double k_place_weight = 0.5;  // of normal_cells()
constexpr double k_spread = 1.5;        // of cell_fields(), mean edges

}  // namespace

std::vector<Index> divided_cells(const PanelMesh& mesh, std::vector<Index> cells, double limit,
                                 ThreadPool& pool) {
  const OpenEdges closed(mesh.edges().size(), 0);
  std::vector<std::vector<Index>> left(1 + *std::max_element(cells.begin(), cells.end()));
  for (Index t = 0; t < cells.size(); ++t)
    left[cells[t]].push_back(t);
  Index number = 0;
  while (!left.empty()) {
    std::vector<PanelPiece> pieces(left.size());
    pool.for_ranges(left.size(), 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t c = begin; c < end; ++c)
        pieces[c] = measured_piece(mesh, closed, std::move(left[c]));
    });
    left.clear();
    for (const PanelPiece& piece : pieces) {
      if (piece.triangles.empty()) continue;
      if (piece.strain() <= limit || piece.triangles.size() < k_least_triangles) {
        for (const Index t : piece.triangles)
          cells[t] = number;
        ++number;
        continue;
      }
      const std::vector<Index> halves = normal_cells(mesh, piece.triangles, 2, k_place_weight);
      left.resize(left.size() + 2);
      for (std::size_t k = 0; k < halves.size(); ++k)
        left[left.size() - 2 + halves[k]].push_back(piece.triangles[k]);
    }
  }
  return cells;
}

std::vector<SurfaceLine> dividing_lines(const PanelMesh& mesh, const OpenEdges& open,
                                        std::span<const Index> triangles, ThreadPool& pool) {
  const PieceCorners corners(mesh, open, triangles);
  TriMesh piece;
  for (std::size_t v = 0; v < corners.vertex_count(); ++v)
    piece.positions.push_back(mesh.patch().positions()[corners.vertex_of(v)]);
  piece.triangles = corners.all_corners();
  const PanelMesh alone{Patch(std::move(piece))};
  std::vector<Index> all(triangles.size());
  std::iota(all.begin(), all.end(), Index{0});
  const std::vector<Index> halves =
      normal_cells(alone, all, corners.border_loops().size() > 1 ? 3 : 2, k_place_weight);
  std::vector<SurfaceLine> lines = tie_lines(alone, cell_fields(alone, halves, k_spread, pool));
  for (SurfaceLine& line : lines) {
    for (SurfacePoint& place : line) {
      for (Index& v : place.corners)
        v = corners.vertex_of(v);
    }
  }
  return lines;
}

}  // namespace planish
