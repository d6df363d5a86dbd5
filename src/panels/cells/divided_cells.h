#pragma once

#include <span>
#include <vector>

#include <planish/mesh/surface_line.h>

#include "core/thread_pool.h"
#include "panels/piece/panel_mesh.h"

namespace planish {

/// Divides each cell with more strain than the limit in two by its normals, again and again. Cells
/// of a few triangles stay.
/// @param cells of each triangle, from 0
std::vector<Index> divided_cells(const PanelMesh& mesh, std::vector<Index> cells, double limit,
                                 ThreadPool& pool);

/// Fair lines that divide a piece in two by its normals, one with holes in three, on the triangles
/// of the mesh.
/// @param triangles of the piece, increasing
std::vector<SurfaceLine> dividing_lines(const PanelMesh& mesh, const OpenEdges& open,
                                        std::span<const Index> triangles, ThreadPool& pool);

}  // namespace planish
