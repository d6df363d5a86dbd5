#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <planish/mesh/patch.h>

#include "cut/small_pieces.h"

namespace planish::cli {

/// What of some paths opens the surface, and the lines of the others.
struct AttachedPaths {
  std::vector<LinePath> paths;
  std::vector<std::size_t> loose = {};  ///< numbers of lines, in the order of the paths
};

/// Leaves out paths that meet neither the border nor a closed way, by themselves or over others:
/// cut open, they would be slits inside a piece. In a part without a border and without a closed
/// way all paths stay: there a slit makes the border.
AttachedPaths attached_paths(const Patch& patch, std::span<const LinePath> paths);

}  // namespace planish::cli
