#pragma once

#include <optional>
#include <span>
#include <vector>

#include <planish/mesh/patch.h>

namespace planish {

/// Along which a surface can be cut and does not fall apart.
struct EssentialPath {
  std::vector<Index> path;  ///< from border to border, or a loop: its first vertex is the last
  bool is_loop = false;     ///< else it begins and ends at the border
  bool is_apart = false;    ///< a loop that does not meet the border
};

/// A short path of edges around a handle, or from one border loop to another; nothing where there
/// is neither, but for holes. Of a greedy homotopy basis (Erickson and Whittlesey 2005): the
/// shortest paths from the border form a forest; triangles are joined across the edges beyond it,
/// those that close the longest paths first; each edge that is left closes a path that divides
/// nothing, and the shortest of these is taken. A closed surface has trees from several vertices
/// tried.
/// @param is_hole by vertex: it is on a border loop that stays as it is
/// @param weights as InsidePaths takes them
/// @pre the mesh is of one part
std::optional<EssentialPath> essential_path(const Patch& patch,
                                            std::span<const unsigned char> is_hole,
                                            std::span<const double> weights);

}  // namespace planish
