#include "unfold/cuts/reduced_paths.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>
#include <utility>

#include <planish/mesh/cut.h>

#include "mesh/cut/cut_paths.h"
#include "mesh/cut/inside_paths.h"
#include "mesh/disjoint_sets.h"
#include "mesh/half_edges.h"

namespace planish {

namespace {

/// The edges of paths that are not on the border, as chains between nodes: places on the border,
/// where chains meet, and ends.
class Chains {
 public:
  Chains(const Patch& patch, const std::vector<EdgeEnds>& edges) : patch_(patch) {
    for (const EdgeEnds& edge : edges) {
      neighbours_[edge[0]].push_back(edge[1]);
      neighbours_[edge[1]].push_back(edge[0]);
    }
    for (const auto& [v, around] : neighbours_) {
      if (!is_node(v)) continue;
      for (const Index next : around)
        follow(v, next);
    }
    for (const auto& [v, around] : neighbours_)
      follow(v, around.front());
  }

  std::vector<std::vector<Index>> take() { return std::move(chains_); }

 private:
  bool is_node(Index v) const { return patch_.is_border(v) || neighbours_.at(v).size() != 2; }

  void follow(Index from, Index next) {
    std::vector<Index> chain = {from};
    while (taken_.insert(std::minmax(chain.back(), next)).second) {
      const Index before = chain.back();
      chain.push_back(next);
      if (is_node(next) || next == from) break;
      const std::vector<Index>& around = neighbours_.at(next);
      next = around[0] == before ? around[1] : around[0];
    }
    if (chain.size() > 1) chains_.push_back(std::move(chain));
  }

  const Patch& patch_;
  std::map<Index, std::vector<Index>> neighbours_;
  std::set<std::pair<Index, Index>> taken_;
  std::vector<std::vector<Index>> chains_;
};

std::vector<EdgeEnds> inner_edges_of(const Patch& patch,
                                     std::span<const std::vector<Index>> paths) {
  std::vector<EdgeEnds> edges = edges_of(paths);
  std::erase_if(edges, [&](const EdgeEnds& edge) {
    return is_border_edge(patch.connectivity(), edge[0], edge[1]);
  });
  return edges;
}

/// Leaves out chains that end inside.
void prune(const Patch& patch, std::vector<std::vector<Index>>& chains) {
  std::map<Index, std::size_t> ends;
  for (const auto& chain : chains) {
    ++ends[chain.front()];
    ++ends[chain.back()];
  }
  const auto is_loose = [&](const std::vector<Index>& chain) {
    if (chain.front() == chain.back()) return false;
    return (ends[chain.front()] == 1 && !patch.is_border(chain.front())) ||
           (ends[chain.back()] == 1 && !patch.is_border(chain.back()));
  };
  for (auto loose = std::find_if(chains.begin(), chains.end(), is_loose); loose != chains.end();
       loose = std::find_if(chains.begin(), chains.end(), is_loose)) {
    --ends[loose->front()];
    --ends[loose->back()];
    chains.erase(loose);
  }
}

}  // namespace

std::vector<std::vector<Index>> inner_chains(const Patch& patch,
                                             std::span<const std::vector<Index>> paths) {
  std::vector<std::vector<Index>> chains = Chains(patch, inner_edges_of(patch, paths)).take();
  std::stable_sort(chains.begin(), chains.end(), [&](const auto& a, const auto& b) {
    return path_length(a, patch.positions()) > path_length(b, patch.positions());
  });
  return chains;
}

std::vector<std::vector<Index>> reduced_paths(const Patch& patch,
                                              std::span<const std::vector<Index>> paths,
                                              bool keep_ends) {
  const std::vector<EdgeEnds> edges = inner_edges_of(patch, paths);
  std::vector<unsigned char> is_met(patch.vertex_count(), 0);
  for (const EdgeEnds& edge : edges)
    is_met[edge[0]] = is_met[edge[1]] = 1;
  const HalfEdges half_edges(patch.mesh());
  DisjointSets<Index> regions(patch.triangles().size());
  std::map<EdgeEnds, Index> half_of;
  for (Index h = 0; h < half_edges.size(); ++h) {
    const Index twin = half_edges.twin(h), v = half_edges.from(h), w = half_edges.to(h);
    if (twin == HalfEdges::none || twin < h) continue;
    const EdgeEnds ends = {std::min(v, w), std::max(v, w)};
    if (is_met[v] != 0 && is_met[w] != 0 && std::binary_search(edges.begin(), edges.end(), ends))
      half_of[ends] = h;
    else
      regions.join(h / 3, twin / 3);
  }
  std::vector<std::vector<Index>> chains = inner_chains(patch, paths);
  std::erase_if(chains, [&](const std::vector<Index>& chain) {
    const Index h = half_of.at({std::min(chain[0], chain[1]), std::max(chain[0], chain[1])});
    const Index left = h / 3, right = half_edges.twin(h) / 3;
    if (regions.first_of(left) == regions.first_of(right)) return false;
    regions.join(left, right);
    return true;
  });
  if (!keep_ends) prune(patch, chains);
  return chains;
}

}  // namespace planish
