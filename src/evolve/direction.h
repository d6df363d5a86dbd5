#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include <planish/mesh/patch.h>

namespace planish {

/// What the surface is like at a vertex, by the sign of its defect (Fig. 1 of the paper). A dome
/// and a cup are the same seen from two sides, so the defect cannot tell them apart.
enum class VertexClass {
  unused,       ///< of no triangle
  border,       ///< has no defect
  flat,         ///< |d| is at most flat_defect()
  dome_or_cup,  ///< d > 0: convex or concave
  saddle,       ///< d < 0
};
std::string_view to_string(VertexClass kind);

/// Where the Laplacian vector L(v) (Eq. 9) leads a vertex.
struct VertexDirection {
  VertexClass kind = VertexClass::unused;
  double defect = 0.0;     ///< d_v, radians
  double slope = 0.0;      ///< L(v) . grad_v b_v: b_v'(0), square radians per step of lambda = 1
  bool can_lower = false;  ///< slope < 0 by more than rounding can feign
};

/// Per vertex whether a small step along the Laplacian vector lowers the ring energy b_v, that is
/// d_v^2 and the d_j^2 of the inner neighbours; the test that Fig. 11 of the paper makes with the
/// vertex's own angle sum only. Where no vertex can be lowered, controllable evolution has only
/// longer steps left. O(sum of the squares of the valences); the same for every size of the model.
std::vector<VertexDirection> laplacian_directions(const Patch& patch);

/// Up to which |defect| a vertex counts as flat, radians: a disk of flat vertices only meets both
/// bounds of is_flattenable().
double flat_defect(std::size_t inner_vertices);

/// How many inner vertices are of which kind.
struct DirectionCounts {
  std::size_t inner = 0, flat = 0, dome_or_cup = 0, saddle = 0;
  std::size_t can_lower = 0;  ///< of all inner vertices
  std::size_t stuck = 0;      ///< neither flat nor to be lowered
};
DirectionCounts count_directions(std::span<const VertexDirection> directions);

}  // namespace planish
