#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <planish/mesh/patch.h>
#include <planish/mesh/surface_line.h>

#include "unfold/disk/disk.h"

namespace planish {

/// The mirror images of a disk's vertices; empty where it has none.
struct DiskImages {
  std::vector<std::size_t> of = {};  ///< each vertex
  std::vector<int> side = {};        ///< of the plane: 1 or -1, 0 on it
};

/// @param plane that the patch is symmetric in, or none
DiskImages images_in(const Patch& patch, const Disk& disk, const std::optional<Plane>& plane);

/// Steps of a symmetric layout are symmetric but for rounding: the mean of both sides is so. Where
/// that turns triangles over, as of a layout that is farther from it, one side and its mirror image
/// are taken, if that does not.
std::vector<Vec2> with_images(const Disk& disk, std::vector<Vec2> flat, const DiskImages& images);

}  // namespace planish
