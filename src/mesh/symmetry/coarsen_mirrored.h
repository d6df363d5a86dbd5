#pragma once

#include <optional>

#include "mesh/coarsen/coarsen.h"
#include "mesh/symmetry/mirror_orbits.h"

namespace planish {

/// As coarsen(), of a patch that is its own mirror image: the half above the plane is coarsened and
/// mirrored. Where the border meets the plane vertices stay. Nothing where the patch is not
/// symmetric, or what comes of it is no patch of the same kind.
/// @throws Cancelled
std::optional<CoarsePatch> coarsen_mirrored(const Patch& patch, const MirrorOrbits& orbits,
                                            std::size_t vertices, CoarseBorder border,
                                            std::span<const unsigned char> keep = {},
                                            const ThreadPool* pool = {});

}  // namespace planish
