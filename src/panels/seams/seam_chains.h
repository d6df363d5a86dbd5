#pragma once

#include <span>
#include <vector>

#include <planish/mesh/surface_line.h>

#include "panels/piece/panel_mesh.h"

namespace planish {

/// A seam between two cells: edges one after the other, from where three seams or more meet, or one
/// ends, or the border is, to the next such vertex; or all around.
struct SeamChain {
  std::vector<Index> edges;
  std::vector<Index> vertices;  ///< one more than edges; of a round chain the last is the first
};

/// Chains of the edges that are set, in the order of their first vertices; round ones last.
std::vector<SeamChain> seam_chains(const PanelMesh& mesh, const OpenEdges& seams);

/// Those of a mirrored mesh that are of its half or on its plane; all of another.
std::vector<SeamChain> chains_of_half(const PanelMesh& mesh, const OpenEdges& seams);

/// A mesh divided into cells along its edges.
struct CellMesh {
  PanelMesh mesh;
  std::vector<Index> cells;  ///< of each triangle, from 0; each cell is in one part
};

/// Makes lines edges of a mesh, and takes what they part as cells, small ones joined to others
/// (with_small_cells_joined()).
/// @param least_area of that of the mesh
CellMesh imprinted_cells(const Patch& patch, std::span<const SurfaceLine> lines, double least_area);

/// Cells below the least area are joined to the neighbour with which they have the longest border.
/// @param cells of each triangle
std::vector<Index> with_small_cells_joined(const PanelMesh& mesh, std::vector<Index> cells,
                                           double least_area);

/// Of each triangle the number of its part, as open_parts() has them.
std::vector<Index> parts_of(const PanelMesh& mesh, const OpenEdges& open);

/// The edge between two vertices; none where there is none.
Index find_edge(const PanelMesh& mesh, Index v, Index w);

}  // namespace planish
