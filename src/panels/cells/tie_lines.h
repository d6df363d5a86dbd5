#pragma once

#include <span>
#include <vector>

#include <planish/mesh/surface_line.h>

#include <Eigen/Core>

#include "core/thread_pool.h"
#include "panels/piece/panel_mesh.h"

namespace planish {

/// How strongly each cell is felt at each vertex (a row a vertex, a column a cell): 1 in it and 0
/// in others, then spread by (M + t L)^-1 M, L the cotangent Laplacian and M areas of vertices.
/// Where the two largest tie is a fair line near the border of the cells (Merriman, Bence and Osher
/// 1994).
/// @param cells of each triangle its cell, from 0
/// @param spread the root of t, mean edges
Eigen::MatrixXd cell_fields(const PanelMesh& mesh, std::span<const Index> cells, double spread,
                            ThreadPool& pool);

/// The lines where the two largest of the fields tie, straight within each triangle, where three do
/// from a place inside it: a line for each such part. Places nearer to a vertex than a tenth of
/// their edge are put there.
std::vector<SurfaceLine> tie_lines(const PanelMesh& mesh, const Eigen::MatrixXd& fields);

}  // namespace planish
