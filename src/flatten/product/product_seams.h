#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <planish/flatten/product.h>

namespace planish {

/// What two borders share, and where they only lie beside each other.
struct ProductSeams {
  std::vector<Seam> seams;
  std::vector<NearBorders> near;
};

/// Of each group of patches by itself, as find_sound_seams(), the groups by their numbers.
/// @param groups number of the group that a patch is in, of each patch
ProductSeams find_seams_in_groups(std::span<const TriMesh> patches,
                                  std::span<const std::size_t> groups, double tolerance);

/// The seams with their lengths.
/// @param meshes as meshes_now() has them
std::vector<MeasuredSeam> measure_seams(std::vector<Seam> seams, std::span<const TriMesh> meshes,
                                        std::span<const PatchResult> results, Unit unit);

}  // namespace planish
