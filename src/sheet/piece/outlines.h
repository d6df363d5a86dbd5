#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <vector>

#include <planish/mesh/tri_mesh.h>

namespace planish {

/// Half-edge 3 t + i runs along triangle t from its corner i to the next.
using HalfEdge = std::uint32_t;
inline constexpr HalfEdge k_no_half_edge = std::numeric_limits<HalfEdge>::max();

/// For each half-edge the one that runs the other way along the same edge, k_no_half_edge on the
/// border. The triangles are manifold and oriented alike, as Connectivity asks.
std::vector<HalfEdge> opposite_half_edges(const TriMesh& mesh);

/// The closed loops of vertices around a part of the mesh, the part on their left; holes have loops
/// of their own. An edge between two triangles of the part is in none. Linear time.
/// @param in_part one per triangle
std::vector<std::vector<Index>> outlines(const TriMesh& mesh, std::span<const HalfEdge> opposite,
                                         const std::function<bool(std::size_t)>& in_part);

}  // namespace planish
