#include "mesh/cut/cut_paths.h"

#include <algorithm>
#include <string>
#include <utility>

#include "core/number_text.h"
#include "mesh/cut/edge_paths.h"
#include "mesh/cut/inside_paths.h"
#include "mesh/disjoint_sets.h"

namespace planish {

namespace {

std::string vertex_text(const Patch& patch, Index v) {
  const Vec3 p = patch.positions()[v];
  return "vertex " + std::to_string(v) + " at (" + number_text(p.x) + ", " + number_text(p.y) +
         ", " + number_text(p.z) + ")";
}

/// Refuses the path of that number, from 0.
[[noreturn]] void refuse_cut(const CutPath& path, std::size_t number, ErrorCode code,
                             const std::string& message, std::optional<std::size_t> vertex) {
  SourceLocation place = path.place;
  place.first = vertex;
  throw Error(code, "cut " + std::to_string(number + 1) + " " + message, place);
}

/// The vertices of a path, checked, without what follows itself.
std::vector<Index> corners_of(const Patch& patch, const CutPath& path, std::size_t number) {
  std::vector<Index> corners;
  corners.reserve(path.vertices.size());
  for (const Index v : path.vertices) {
    if (v >= patch.vertex_count()) {
      refuse_cut(path, number, ErrorCode::index_out_of_range,
                 "names vertex " + std::to_string(v) + ": the mesh has " +
                     std::to_string(patch.vertex_count()) + " vertices, counted from 0",
                 v);
    }
    if (patch.ring(v).empty()) {
      refuse_cut(path, number, ErrorCode::misplaced_cut,
                 "names " + vertex_text(patch, v) + ", which no triangle uses", v);
    }
    if (corners.empty() || corners.back() != v) corners.push_back(v);
  }
  if (corners.size() >= 2) return corners;
  if (corners.empty()) {
    refuse_cut(path, number, ErrorCode::misplaced_cut, "has no vertices: it needs two at least",
               std::nullopt);
  }
  refuse_cut(
      path, number, ErrorCode::misplaced_cut,
      "has one vertex only, " + vertex_text(patch, corners.front()) + ": it needs two at least",
      corners.front());
}

/// The parts that vertices and edges hang together in.
using Parts = DisjointSets<Index>;

/// By vertex: whether the part of the mesh that it is in has a border.
std::vector<unsigned char> in_open_part(const Connectivity& connectivity) {
  const auto count = static_cast<Index>(connectivity.vertex_count());
  Parts parts(count);
  for (Index v = 0; v < count; ++v) {
    for (const Index w : connectivity.ring(v))
      parts.join(v, w);
  }
  std::vector<unsigned char> open(count, 0);
  for (const auto& loop : connectivity.border_loops())
    open[parts.first_of(loop.front())] = 1;
  for (Index v = 0; v < count; ++v)
    open[v] = open[parts.first_of(v)];
  return open;
}

}  // namespace

std::vector<std::vector<Index>> full_paths(const Patch& patch, std::span<const CutPath> paths) {
  InsidePaths inside(patch);
  std::vector<std::vector<Index>> full;
  full.reserve(paths.size());
  for (std::size_t k = 0; k < paths.size(); ++k) {
    const std::vector<Index> corners = corners_of(patch, paths[k], k);
    std::vector<Index>& path = full.emplace_back(1, corners.front());
    for (std::size_t i = 1; i < corners.size(); ++i) {
      const Index v = corners[i - 1], w = corners[i];
      const auto ring = patch.ring(v);
      if (std::find(ring.begin(), ring.end(), w) != ring.end()) {
        if (is_border_edge(patch.connectivity(), v, w)) {
          refuse_cut(paths[k], k, ErrorCode::misplaced_cut,
                     "runs along the border from " + vertex_text(patch, v) + " to " +
                         vertex_text(patch, w) + ": there is nothing to cut",
                     v);
        }
        path.push_back(w);
        continue;
      }
      const auto way = inside.from(std::span(&v, 1), [w](Index at) { return at == w; });
      if (!way) {
        refuse_cut(paths[k], k, ErrorCode::misplaced_cut,
                   "finds no way inside the mesh from " + vertex_text(patch, v) + " to " +
                       vertex_text(patch, w),
                   v);
      }
      path.insert(path.end(), way->begin() + 1, way->end());
      if (inside.looks() > k_most_looks) {
        refuse_cut(
            paths[k], k, ErrorCode::too_large,
            "is one too many: the ways between the vertices of all cuts are too long together", v);
      }
    }
  }
  return full;
}

std::vector<EdgeEnds> edges_of(std::span<const std::vector<Index>> paths) {
  std::vector<EdgeEnds> edges;
  for (const auto& path : paths) {
    for (std::size_t i = 1; i < path.size(); ++i)
      edges.push_back({std::min(path[i - 1], path[i]), std::max(path[i - 1], path[i])});
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

void refuse_idle_cuts(const Patch& patch, std::span<const CutPath> paths,
                      std::span<const std::vector<Index>> full) {
  const std::vector<unsigned char> open = in_open_part(patch.connectivity());
  Parts together(patch.vertex_count());  // what the paths join
  std::vector<unsigned char> touches(patch.vertex_count(), 0);
  std::vector<std::size_t> edges(patch.vertex_count(), 0), vertices(patch.vertex_count(), 0);
  const std::vector<EdgeEnds> all = edges_of(full);
  for (const EdgeEnds& edge : all)
    together.join(edge[0], edge[1]);
  for (const EdgeEnds& edge : all) {
    const Index part = together.first_of(edge[0]);
    ++edges[part];
    if (patch.is_border(edge[0]) || patch.is_border(edge[1])) touches[part] = 1;
  }
  std::vector<Index> ends;
  ends.reserve(2 * all.size());
  for (const EdgeEnds& edge : all)
    ends.insert(ends.end(), edge.begin(), edge.end());
  std::sort(ends.begin(), ends.end());
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  for (const Index v : ends)
    ++vertices[together.first_of(v)];
  for (std::size_t k = 0; k < full.size(); ++k) {
    const Index first = full[k].front(), part = together.first_of(first);
    const bool is_closed = edges[part] >= vertices[part];
    if (touches[part] != 0 || is_closed) continue;
    if (open[first] != 0) {
      refuse_cut(paths[k], k, ErrorCode::misplaced_cut,
                 "from " + vertex_text(patch, first) + " to " + vertex_text(patch, full[k].back()) +
                     " never meets the border and would only open a hole: let it begin or end at "
                     "the border, or end where it begins",
                 first);
    }
    if (edges[part] < 2) {
      refuse_cut(paths[k], k, ErrorCode::misplaced_cut,
                 "is the single edge from " + vertex_text(patch, first) + " to " +
                     vertex_text(patch, full[k].back()) +
                     ", which opens nothing in a closed surface: two edges do",
                 first);
    }
  }
}

}  // namespace planish
