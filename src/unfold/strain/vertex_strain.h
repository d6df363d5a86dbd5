#pragma once

#include <span>
#include <vector>

#include <planish/mesh/patch.h>
#include <planish/unfold/strain.h>

namespace planish {

/// The strain of every vertex: the mean over its triangles of their strain of largest size, with
/// its sign (signed_strains()); 0 for vertices without triangles.
/// @param pattern one position per vertex of the mesh
std::vector<double> vertex_strains(const TriMesh& mesh, std::span<const Vec2> pattern);

/// The strain of largest size among the edges of every vertex, with its sign; 0 for vertices
/// without edges. The largest of all is edge_strain()'s.
/// @param pattern one position per vertex of the mesh
/// @param weight_of_stretch what counts for 1 of a strain below 0, where one above counts for 1
std::vector<double> largest_edge_strains(const Patch& patch, std::span<const Vec2> pattern,
                                         double weight_of_stretch = 1.0);

/// The strain of largest size among the three edges of every triangle, with its sign.
/// @param pattern one position per vertex of the mesh
/// @param weight_of_stretch as of largest_edge_strains()
std::vector<double> largest_edge_strains_of_triangles(const TriMesh& mesh,
                                                      std::span<const Vec2> pattern,
                                                      double weight_of_stretch = 1.0);

/// The principal stretches of every vertex: the means over its triangles; none for vertices without
/// triangles.
/// @param pattern one position per vertex of the mesh
std::vector<PrincipalStretch> vertex_stretches(const TriMesh& mesh, std::span<const Vec2> pattern);

}  // namespace planish
