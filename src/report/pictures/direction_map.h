#pragma once

#include <span>
#include <string>

#include <planish/mesh/tri_mesh.h>

#include "evolve/direction.h"

namespace planish {

/// The directions as comma-separated values: a header line "vertex,class,defect,laplacian_slope,
/// can_lower", then a line a vertex in the order of the mesh. What is not inner has a class only.
std::string direction_csv(std::span<const VertexDirection> directions);

/// Two pictures of the patch side by side as an SVG file: at the left the class of each vertex, at
/// the right whether the Laplacian direction lowers its ring energy; below them what the colours
/// mean and how many vertices have each.
/// @param directions of laplacian_directions(mesh)
/// @param name of the patch, for the title
std::string direction_svg(const TriMesh& mesh, std::span<const VertexDirection> directions,
                          const std::string& name);

}  // namespace planish
