#pragma once

#include <span>
#include <vector>

#include <planish/mesh/patch.h>

namespace planish {

/// Distances over the surface from some vertices to all, model units; infinite where no way leads.
/// Plane waves through triangles (Kimmel and Sethian 1998): of first order, too far by up
/// to a quarter of an edge times the logarithm of the way in edges.
std::vector<double> distances_from(const Patch& patch, std::span<const Index> sources);

/// Length of the line at a distance, straight in each triangle, model units.
double front_length(const TriMesh& mesh, std::span<const double> distances, double at);

}  // namespace planish
