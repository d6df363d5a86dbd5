#include "cut/loose_paths.h"

#include <algorithm>
#include <array>
#include <set>

#include "mesh/disjoint_sets.h"

namespace planish::cli {

namespace {

using Ends = std::array<Index, 2>;

}  // namespace

AttachedPaths attached_paths(const Patch& patch, std::span<const LinePath> paths) {
  const std::size_t count = patch.vertex_count();
  DisjointSets<Index> parts(count), nets(count);
  for (const Triangle& t : patch.triangles()) {
    parts.join(t[0], t[1]);
    parts.join(t[0], t[2]);
  }
  std::set<Ends> edges;
  std::vector<Index> closing;  // vertices of edges whose ends were joined before
  for (const LinePath& path : paths) {
    for (std::size_t i = 1; i < path.vertices.size(); ++i) {
      const auto [v, w] = std::minmax(path.vertices[i - 1], path.vertices[i]);
      if (!edges.insert({v, w}).second) continue;
      if (nets.first_of(v) == nets.first_of(w)) closing.push_back(v);
      nets.join(v, w);
    }
  }
  std::vector<unsigned char> is_attached(count, 0), has_border(count, 0);  // by first vertex
  for (const Index v : closing) {
    is_attached[nets.first_of(v)] = 1;
    has_border[parts.first_of(v)] = 1;
  }
  for (Index v = 0; v < count; ++v) {
    if (!patch.is_border(v)) continue;
    is_attached[nets.first_of(v)] = 1;
    has_border[parts.first_of(v)] = 1;
  }
  AttachedPaths result;
  for (const LinePath& path : paths) {
    const Index v = path.vertices.empty() ? 0 : path.vertices.front();
    const bool stays = path.vertices.size() < 2 || is_attached[nets.first_of(v)] != 0 ||
                       has_border[parts.first_of(v)] == 0;
    if (stays) {
      result.paths.push_back(path);
    } else if (std::find(result.loose.begin(), result.loose.end(), path.line) ==
               result.loose.end()) {
      result.loose.push_back(path.line);
    }
  }
  return result;
}

}  // namespace planish::cli
