#include "mesh/geodesic/loop_finder.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace planish {

namespace {

/// Of the squared length of a loop: more than what paths along edges enclose on a flat mesh.
constexpr double k_least_area = 0.2;

bool is_on_path(const InsidePaths::Tree& paths, Index v, Index w) {
  return paths.previous[v] == w || paths.previous[w] == v;
}

std::vector<Index> way_back(const InsidePaths::Tree& paths, Index v) {
  std::vector<Index> way = {v};
  while (paths.previous[way.back()] != way.back())
    way.push_back(paths.previous[way.back()]);
  return way;
}

}  // namespace

/// Triangles and holes, joined into a tree by edges that no path runs along (Eppstein 2003).
struct LoopFinder::Sides {
  std::vector<Index> order = {};    // of triangles and holes, each behind its parent
  std::vector<Index> parent = {};   // by triangle or hole
  std::vector<Index> entered = {};  // and a half-edge of the edge to the parent
  std::vector<double> area = {};    // with all behind it
  std::vector<int> ways_out = {};   // other edges that lead out of what is behind it
  std::vector<Index> others = {};   // edges that close a way around a handle
};

LoopFinder::LoopFinder(const Patch& patch)
    : patch_(patch), half_edges_(patch.mesh()), hole_of_(half_edges_.size(), HalfEdges::none) {
  const double scale = patch.unit_scale();
  const auto at = [&](Index v) { return scale * patch.positions()[v]; };
  area_.reserve(patch.triangles().size() + patch.border_loops().size());
  for (const Triangle& t : patch.triangles())
    area_.push_back(0.5 * norm(cross(at(t[1]) - at(t[0]), at(t[2]) - at(t[0]))));
  for (const auto& loop : patch.border_loops()) {
    std::vector<Index>& border = borders_.emplace_back();
    double length = 0.0;
    for (const Index v : loop) {
      border.push_back(half_edges_.first(v));
      hole_of_[border.back()] = static_cast<Index>(area_.size());
      length += norm(at(half_edges_.to(border.back())) - at(v));
    }
    area_.push_back(length * length / (4.0 * std::numbers::pi));
  }
}

InsidePaths::Tree LoopFinder::paths_from(Index v) const {
  return InsidePaths(patch_).tree(std::span(&v, 1));
}

Index LoopFinder::node_beyond(Index half) const {
  const Index twin = half_edges_.twin(half);
  return twin == HalfEdges::none ? hole_of_[half] : twin / 3;
}

LoopFinder::Sides LoopFinder::sides(Index v, const InsidePaths::Tree& paths) const {
  const std::size_t count = area_.size(), triangles = patch_.triangles().size();
  Sides tree{.parent = std::vector<Index>(count, HalfEdges::none),
             .entered = std::vector<Index>(count, HalfEdges::none),
             .area = area_,
             .ways_out = std::vector<int>(count, 0)};
  std::vector<unsigned char> reached(count, 0), is_crossed(half_edges_.size(), 0);
  std::vector<std::size_t> depth(count, 0);
  tree.order.push_back(half_edges_.first(v) / 3);
  reached[tree.order.front()] = 1;
  const auto look = [&](Index node, Index half, Index beyond) {
    if (reached[beyond] != 0) return;
    if (is_on_path(paths, half_edges_.from(half), half_edges_.to(half))) return;
    reached[beyond] = is_crossed[edge_of(half)] = 1;
    tree.parent[beyond] = node;
    tree.entered[beyond] = half;
    depth[beyond] = depth[node] + 1;
    tree.order.push_back(beyond);
  };
  for (std::size_t next = 0; next < tree.order.size();) {
    const Index node = tree.order[next++];
    if (node < triangles) {
      for (Index half = 3 * node; half < 3 * node + 3; ++half)
        look(node, half, node_beyond(half));
    } else {
      for (const Index half : borders_[node - triangles])
        look(node, half, half / 3);
    }
  }
  for (Index half = 0; half < half_edges_.size(); ++half) {
    if (edge_of(half) != half || is_crossed[half] != 0 || reached[half / 3] == 0 ||
        is_on_path(paths, half_edges_.from(half), half_edges_.to(half)))
      continue;
    tree.others.push_back(half);
    Index a = half / 3, b = node_beyond(half);
    ++tree.ways_out[a];
    ++tree.ways_out[b];
    while (a != b) {
      Index& deeper = depth[a] < depth[b] ? b : a;
      deeper = tree.parent[deeper];
    }
    tree.ways_out[a] -= 2;
  }
  for (std::size_t i = tree.order.size() - 1; i > 0; --i) {
    const Index node = tree.order[i], parent = tree.parent[node];
    tree.area[parent] += tree.area[node];
    tree.ways_out[parent] += tree.ways_out[node];
  }
  return tree;
}

std::optional<std::vector<Index>> LoopFinder::shortest_loop(Index v,
                                                            const InsidePaths::Tree& paths) const {
  const Sides tree = sides(v, paths);
  const double all = tree.area[tree.order.front()], scale = patch_.unit_scale();
  std::optional<Index> best;
  double least = std::numeric_limits<double>::infinity();
  const auto length_by = [&](Index half) {
    const Index a = half_edges_.from(half), b = half_edges_.to(half);
    return paths.distance[a] + paths.distance[b] +
           norm(scale * patch_.positions()[b] - scale * patch_.positions()[a]);
  };
  const auto take = [&](Index half, double length) {
    if (length < least) least = length, best = half;
  };
  for (std::size_t i = 1; i < tree.order.size(); ++i) {
    const Index node = tree.order[i];
    const double length = length_by(tree.entered[node]);
    const double smaller = std::min(tree.area[node], all - tree.area[node]);
    if (tree.ways_out[node] != 0 || smaller >= k_least_area * length * length)
      take(tree.entered[node], length);
  }
  for (const Index half : tree.others)
    take(half, length_by(half));
  if (!best) return std::nullopt;
  std::vector<Index> loop = way_back(paths, half_edges_.from(*best)),
                     back = way_back(paths, half_edges_.to(*best));
  while (loop.size() > 1 && back.size() > 1 && loop[loop.size() - 2] == back[back.size() - 2]) {
    loop.pop_back();
    back.pop_back();
  }
  std::reverse(loop.begin(), loop.end());
  loop.insert(loop.end(), back.begin(), back.end());
  return loop;
}

}  // namespace planish
