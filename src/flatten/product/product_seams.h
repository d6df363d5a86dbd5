#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include <planish/flatten/product.h>

#include "mesh/match/twins.h"

namespace planish {

/// find_near_borders() of each group of patches by itself, as find_seams_in_groups(), with the
/// seams found first.
std::vector<NearBorders> find_near_borders_in_groups(std::span<const TriMesh> patches,
                                                     std::span<const std::size_t> groups,
                                                     double tolerance);

/// Of each patch. Of twins, an edge is free if it is in all of them.
/// @param meshes of the patches; those that cannot be measured have no seams
/// @param twins of each, as find_twins() gives them
std::vector<SewnBorder> find_sewn_borders(std::span<const Seam> seams,
                                          std::span<const TriMesh> meshes,
                                          std::span<const std::optional<MeshTwin>> twins);

/// The seams with their lengths.
/// @param meshes as meshes_now() has them
std::vector<MeasuredSeam> measure_seams(std::vector<Seam> seams, std::span<const TriMesh> meshes,
                                        std::span<const PatchResult> results, Unit unit);

}  // namespace planish
