#pragma once

#include <planish/evolve/constraints.h>
#include <planish/mesh/patch.h>
#include <planish/mesh/symmetry.h>

#include "mesh/symmetry/mirror_orbits.h"

namespace planish {

/// Vertices with their mirror images, where half of a patch stands for both: its triangles have
/// mirror images too, both sides are fixed and weighted alike, and it has no holes.
/// @param symmetry of the vertices of the patch
MirrorOrbits mirror_orbits_of(const Patch& patch, const Symmetry& symmetry,
                              const Constraints& constraints);

}  // namespace planish
