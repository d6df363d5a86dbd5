#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "panels/piece/panel_mesh.h"

namespace planish {

/// Divides a piece of a mesh into connected cells that are nearly plane, by their normals: Lloyd's
/// rounds in the metric L2,1 (Cohen-Steiner, Alliez and Desbrun, Variational shape approximation,
/// 2004). Seeds are spread by steps from triangle to triangle. Always the same.
/// @param triangles of the piece, increasing, in one part
/// @param count the largest number of cells
/// @param place_weight what squares of distances from the middle of a cell count for, of the area
/// of
///   the piece, beside squares of differences of normals; more than 0 makes cells compact
/// @return of each of the triangles its cell, from 0
std::vector<Index> normal_cells(const PanelMesh& mesh, std::span<const Index> triangles,
                                std::size_t count, double place_weight = 0.0);

}  // namespace planish
