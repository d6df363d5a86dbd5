#pragma once

#include <span>
#include <vector>

#include <planish/flatten/product.h>

namespace planish {

/// The seams of the patches as they are now, with their lengths.
/// @param meshes as meshes_now() has them
std::vector<MeasuredSeam> measure_seams(std::span<const TriMesh> meshes,
                                        std::span<const PatchResult> results, double tolerance,
                                        Unit unit);

}  // namespace planish
