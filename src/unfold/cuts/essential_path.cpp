#include "unfold/cuts/essential_path.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>

#include "mesh/cut/inside_paths.h"
#include "mesh/disjoint_sets.h"
#include "mesh/half_edges.h"

namespace planish {

namespace {

constexpr double k_unreached = std::numeric_limits<double>::infinity();
constexpr std::size_t k_roots = 12;  // that are tried on a closed surface

/// From v back to where its path begins.
std::vector<Index> path_back(const InsidePaths::Tree& paths, Index v) {
  std::vector<Index> path = {v};
  while (paths.previous[path.back()] != path.back())
    path.push_back(paths.previous[path.back()]);
  return path;
}

/// An edge that no path of the tree takes.
struct Beyond {
  double rank;  ///< length of what it closes; infinite where that is not to be taken
  Index half;   ///< one of its half-edges
};

/// Finds the edges that close paths which divide nothing.
class Closers {
 public:
  Closers(const Patch& patch, std::span<const unsigned char> is_hole,
          std::span<const double> weights)
      : patch_(patch), weights_(weights), half_edges_(patch.mesh()) {
    const auto& loops = patch.border_loops();
    hole_of_.assign(patch.vertex_count(), loops.size());
    for (std::size_t k = 0; k < loops.size(); ++k) {
      if (!is_all_hole(loops[k], is_hole)) {
        roots_.insert(roots_.end(), loops[k].begin(), loops[k].end());
        continue;
      }
      for (const Index v : loops[k])
        hole_of_[v] = k;
    }
  }

  /// The vertices of the border but for holes.
  const std::vector<Index>& roots() const { return roots_; }

  /// Half-edges, those that close the shortest paths last.
  std::vector<Index> of(const InsidePaths::Tree& paths) const {
    const auto triangles = static_cast<Index>(patch_.triangles().size());
    DisjointSets<Index> joined(triangles + patch_.border_loops().size());
    for (Index h = 0; h < half_edges_.size(); ++h) {
      if (half_edges_.twin(h) == HalfEdges::none && is_on_hole(half_edges_.from(h)))
        joined.join(h / 3, triangles + static_cast<Index>(hole_of_[half_edges_.from(h)]));
    }
    std::vector<Index> closers;
    for (const Beyond& edge : beyond(paths)) {
      const Index left = edge.half / 3, right = half_edges_.twin(edge.half) / 3;
      if (joined.first_of(left) != joined.first_of(right)) {
        joined.join(left, right);
      } else if (paths.distance[half_edges_.from(edge.half)] < k_unreached &&
                 paths.distance[half_edges_.to(edge.half)] < k_unreached) {
        closers.push_back(edge.half);
      }
    }
    return closers;
  }

  double length(Index h) const {
    const Index v = half_edges_.from(h), w = half_edges_.to(h);
    const Vec3 edge =
        patch_.unit_scale() * patch_.positions()[w] - patch_.unit_scale() * patch_.positions()[v];
    return weights_.empty() ? norm(edge) : 0.5 * (weights_[v] + weights_[w]) * norm(edge);
  }

  const HalfEdges& half_edges() const { return half_edges_; }

 private:
  std::vector<Beyond> beyond(const InsidePaths::Tree& paths) const {
    std::vector<Beyond> edges;
    for (Index h = 0; h < half_edges_.size(); ++h) {
      const Index twin = half_edges_.twin(h), v = half_edges_.from(h), w = half_edges_.to(h);
      if (twin == HalfEdges::none || twin < h) continue;
      if (paths.previous[v] == w || paths.previous[w] == v) continue;
      const bool meets_hole = is_on_hole(v) || is_on_hole(w);
      const double rank = paths.distance[v] + length(h) + paths.distance[w];
      edges.push_back({meets_hole ? k_unreached : rank, h});
    }
    std::stable_sort(edges.begin(), edges.end(),
                     [](const Beyond& a, const Beyond& b) { return a.rank > b.rank; });
    return edges;
  }

  static bool is_all_hole(const std::vector<Index>& loop, std::span<const unsigned char> is_hole) {
    return std::all_of(loop.begin(), loop.end(), [&](Index v) { return is_hole[v] != 0; });
  }

  bool is_on_hole(Index v) const { return hole_of_[v] < patch_.border_loops().size(); }

  const Patch& patch_;
  std::span<const double> weights_;
  HalfEdges half_edges_;
  std::vector<Index> roots_;
  std::vector<std::size_t> hole_of_;  // by vertex; the number of loops: of none
};

/// A path with its length.
struct Candidate {
  EssentialPath found;
  double length = k_unreached;
};

/// What an edge closes; what its two ways have in common does not belong to it.
Candidate closed_by(const Patch& patch, const Closers& closers, const InsidePaths::Tree& paths,
                    Index half) {
  const Index v = closers.half_edges().from(half), w = closers.half_edges().to(half);
  std::vector<Index> there = path_back(paths, v), back = path_back(paths, w);
  const bool is_loop = there.back() == back.back();
  while (is_loop && there.size() > 1 && back.size() > 1 &&
         there[there.size() - 2] == back[back.size() - 2]) {
    there.pop_back();
    back.pop_back();
  }
  const Index first = there.back(), last = back.back();
  const double length = paths.distance[v] - paths.distance[first] + closers.length(half) +
                        paths.distance[w] - paths.distance[last];
  // What is apart from the border needs a way there too.
  Candidate candidate{{{}, is_loop, !patch.is_border(first)}, length + paths.distance[first]};
  std::reverse(there.begin(), there.end());
  candidate.found.path = std::move(there);
  candidate.found.path.insert(candidate.found.path.end(), back.begin(), back.end());
  if (!candidate.found.is_apart && is_loop) candidate.found.is_loop = false;
  return candidate;
}

/// The shortest of what edges beyond a tree close.
Candidate shortest(const Patch& patch, const Closers& closers, const InsidePaths::Tree& paths) {
  Candidate best;
  for (const Index half : closers.of(paths)) {
    Candidate next = closed_by(patch, closers, paths, half);
    if (next.length < best.length) best = std::move(next);
  }
  return best;
}

Candidate shortest_of_closed(const Patch& patch, const Closers& closers,
                             std::span<const double> weights) {
  Candidate best;
  InsidePaths inside(patch, weights);
  std::vector<double> from_roots(patch.vertex_count(), k_unreached);
  Index root = patch.triangles().front().front();
  for (std::size_t k = 0; k < k_roots; ++k) {
    const InsidePaths::Tree paths = inside.tree(std::span(&root, 1));
    Candidate next = shortest(patch, closers, paths);
    next.length -= paths.distance[next.found.path.empty() ? root : next.found.path.front()];
    if (next.length < best.length) best = std::move(next);
    for (std::size_t v = 0; v < from_roots.size(); ++v) {
      // Vertices that no triangle uses are never reached.
      if (paths.distance[v] < k_unreached)
        from_roots[v] = std::min(from_roots[v], paths.distance[v]);
      else
        from_roots[v] = 0.0;
    }
    root = static_cast<Index>(std::max_element(from_roots.begin(), from_roots.end()) -
                              from_roots.begin());
    if (from_roots[root] == 0.0) break;
  }
  return best;
}

}  // namespace

std::optional<EssentialPath> essential_path(const Patch& patch,
                                            std::span<const unsigned char> is_hole,
                                            std::span<const double> weights) {
  const Closers closers(patch, is_hole, weights);
  Candidate best =
      closers.roots().empty()
          ? shortest_of_closed(patch, closers, weights)
          : shortest(patch, closers, InsidePaths(patch, weights).tree(closers.roots()));
  if (best.found.path.empty()) return std::nullopt;
  return std::move(best.found);
}

}  // namespace planish
