#pragma once

#include <cstddef>
#include <vector>

#include "energy/angle_jacobian.h"
#include "evolve/state/patch_state.h"

namespace planish {

/// Keeps triangles from becoming needles while vertices move along their normals: where the worst
/// triangle at a vertex has become a poor one, the vertex slides along the surface towards the
/// middle of its neighbours, as far as makes the worst triangle best.
class TangentialRelaxation {
 public:
  /// Notes the shapes of triangles as they are: those that are poor from the start may stay so.
  /// @param jacobian,state must outlive it
  TangentialRelaxation(const AngleJacobian& jacobian, PatchState& state);

  /// One pass over all vertices, each seeing what those before it did.
  /// @return how many moved
  std::size_t relax();

 private:
  double worst_shape(Index v, Vec3 place) const;

  const AngleJacobian& jacobian_;
  PatchState& state_;
  std::vector<double> least_;  // shape below which a vertex slides
};

}  // namespace planish
