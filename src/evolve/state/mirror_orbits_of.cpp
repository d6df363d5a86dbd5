#include "evolve/state/mirror_orbits_of.h"

#include <cstddef>
#include <vector>

#include "evolve/state/fixed_marks.h"
#include "mesh/border_loops.h"

namespace planish {

MirrorOrbits mirror_orbits_of(const Patch& patch, const Symmetry& symmetry,
                              const Constraints& constraints) {
  const std::vector<Index>& image = symmetry.image;
  if (image.empty() || !hole_loops(patch).empty()) return {};
  const std::vector<unsigned char> fixed = fixed_marks(constraints, patch.vertex_count());
  const std::vector<double>& weights = constraints.weights;
  for (std::size_t v = 0; v < image.size(); ++v) {
    if (!fixed.empty() && fixed[v] != fixed[image[v]]) return {};
    if (!weights.empty() && weights[v] != weights[image[v]]) return {};
  }
  return mirror_orbits(patch.mesh(), symmetry);
}

}  // namespace planish
