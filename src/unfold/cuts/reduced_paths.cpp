#include "unfold/cuts/reduced_paths.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include <planish/mesh/cut.h>

#include "mesh/cut/inside_paths.h"
#include "mesh/half_edges.h"

namespace planish {

namespace {

/// Follows edges between nodes: places on the border, where chains meet, and ends.
class ChainMaker {
 public:
  ChainMaker(const Patch& patch, const std::vector<EdgeEnds>& edges) : patch_(patch) {
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

  Chains take() { return std::move(chains_); }

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
  Chains chains_;
};

EdgeEnds first_edge(std::span<const Index> chain) {
  return {std::min(chain[0], chain[1]), std::max(chain[0], chain[1])};
}

}  // namespace

Chains inner_chains(const Patch& patch, std::span<const std::vector<Index>> paths) {
  std::vector<EdgeEnds> edges = edges_of(paths);
  std::erase_if(edges, [&](const EdgeEnds& edge) {
    return is_border_edge(patch.connectivity(), edge[0], edge[1]);
  });
  Chains chains = ChainMaker(patch, edges).take();
  std::stable_sort(chains.begin(), chains.end(), [&](const auto& a, const auto& b) {
    return path_length(a, patch.positions()) > path_length(b, patch.positions());
  });
  return chains;
}

Chains without_loose(const Patch& patch, Chains chains) {
  std::map<Index, std::size_t> ends;
  for (const auto& chain : chains) {
    ++ends[chain.front()];
    ++ends[chain.back()];
  }
  const auto is_loose = [&](const std::vector<Index>& chain) {
    return (ends[chain.front()] == 1 && !patch.is_border(chain.front())) ||
           (ends[chain.back()] == 1 && !patch.is_border(chain.back()));
  };
  std::size_t before = 0;
  while (chains.size() != before) {
    before = chains.size();
    std::erase_if(chains, [&](const std::vector<Index>& chain) {
      if (!is_loose(chain)) return false;
      --ends[chain.front()];
      --ends[chain.back()];
      return true;
    });
  }
  return chains;
}

Regions::Regions(const Patch& patch, std::span<const std::vector<Index>> chains)
    : sets_(patch.triangles().size()),
      areas_(patch.triangles().size(), 0.0),
      edges_(edges_of(chains)),
      beside_(edges_.size()) {
  std::vector<unsigned char> is_met(patch.vertex_count(), 0);
  for (const EdgeEnds& edge : edges_)
    is_met[edge[0]] = is_met[edge[1]] = 1;
  const HalfEdges half_edges(patch.mesh());
  for (Index h = 0; h < half_edges.size(); ++h) {
    const Index twin = half_edges.twin(h), v = half_edges.from(h), w = half_edges.to(h);
    if (twin == HalfEdges::none || w < v) continue;
    if (is_met[v] != 0 && is_met[w] != 0) {
      const auto at = std::lower_bound(edges_.begin(), edges_.end(), EdgeEnds{v, w});
      if (at != edges_.end() && *at == EdgeEnds{v, w}) {
        beside_[static_cast<std::size_t>(at - edges_.begin())] = {h / 3, twin / 3};
        continue;
      }
    }
    sets_.join(h / 3, twin / 3);
  }
  const double scale = patch.unit_scale();
  for (Index t = 0; t < patch.triangles().size(); ++t) {
    const auto corner = [&](int k) { return scale * patch.positions()[patch.triangles()[t][k]]; };
    areas_[sets_.first_of(t)] += 0.5 * norm(cross(corner(1) - corner(0), corner(2) - corner(0)));
    if (sets_.first_of(t) == t) ++count_;
  }
}

Regions::Sides Regions::sides(std::span<const Index> chain) {
  const auto at = std::lower_bound(edges_.begin(), edges_.end(), first_edge(chain));
  const Sides triangles = beside_[static_cast<std::size_t>(at - edges_.begin())];
  return {sets_.first_of(triangles.left), sets_.first_of(triangles.right)};
}

void Regions::join(const Sides& sides) {
  if (sides.left == sides.right) return;
  const double area = areas_[sides.left] + areas_[sides.right];
  sets_.join(sides.left, sides.right);
  areas_[sets_.first_of(sides.left)] = area;
  --count_;
}

Chains reduced_paths(const Patch& patch, std::span<const std::vector<Index>> paths,
                     bool keep_ends) {
  Chains chains = inner_chains(patch, paths);
  Regions regions(patch, chains);
  std::erase_if(chains, [&](const std::vector<Index>& chain) {
    const Regions::Sides sides = regions.sides(chain);
    regions.join(sides);
    return sides.left != sides.right;
  });
  return keep_ends ? chains : without_loose(patch, std::move(chains));
}

}  // namespace planish
