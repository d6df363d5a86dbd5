#pragma once

#include <optional>
#include <span>
#include <vector>

#include <planish/evolve/method.h>
#include <planish/mesh/surface_line.h>
#include <planish/mesh/tri_mesh.h>

namespace planish {

/// What an evolution respects besides the border. Vertices are numbered as in the mesh.
struct Constraints {
  std::vector<Index> fixed = {};  ///< vertices that stay where they are
  std::vector<double> weights =
      {};                 ///< one per vertex, 1e-6 to 1e6: the weight of its moves; none: 1
  TriMesh obstacle = {};  ///< closed surface, oriented outwards, not to be entered; may be none
  /// A patch that is symmetric in this plane vertex by vertex (Symmetry::image) stays so: `auto`
  /// solves for half with Prefer::smooth and flat where it can, else moves are the means of those
  /// of both sides. Idle for others.
  std::optional<Plane> symmetric_in = {};
};

/// What is asked of some of the vertices, numbered by their place in `source`.
/// @param source vertex there -> vertex of the constraints, increasing
Constraints restricted_to(const Constraints& constraints, std::span<const Index> source);

/// Whether a method does something with weights, or with an obstacle. Every method honours fixed
/// vertices.
bool honours_weights(const Method& method);
/// Likewise of an obstacle.
bool honours_obstacle(const Method& method);

/// @throws Error index_out_of_range, option_out_of_range for weights that are too few or out of
///   range, unsupported_constraint for what the method cannot honour, and for an obstacle that does
///   not tell its inside from its outside the code of its fault, as open_surface
void check_constraints(const Constraints& constraints, std::size_t vertex_count,
                       const Method& method);

}  // namespace planish
