#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <planish/flatten/product.h>

namespace planish {

/// find_near_borders() of each group of patches by itself, as find_seams_in_groups(), with the
/// seams found first.
std::vector<NearBorders> find_near_borders_in_groups(std::span<const TriMesh> patches,
                                                     std::span<const std::size_t> groups,
                                                     double tolerance);

/// The seams with their lengths.
/// @param meshes as meshes_now() has them
std::vector<MeasuredSeam> measure_seams(std::vector<Seam> seams, std::span<const TriMesh> meshes,
                                        std::span<const PatchResult> results, Unit unit);

}  // namespace planish
