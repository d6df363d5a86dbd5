#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <planish/mesh/patch.h>

namespace planish {

/// An edge of the border of a patch among those of several patches, which are in one row, loop
/// after loop.
struct BorderEdge {
  std::size_t patch;
  Index from, to;
  std::size_t next, previous;  ///< along the loop
};

/// @throws Error as Patch
std::vector<BorderEdge> border_edges(std::span<const TriMesh> patches);
std::vector<BorderEdge> border_edges(std::span<const Patch> patches);

}  // namespace planish
