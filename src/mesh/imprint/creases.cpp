#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <planish/mesh/surface_line.h>

#include "geometry/dihedral_angle.h"

namespace planish {

namespace {

/// Edges of a mesh, each chained to the next one.
class EdgeChains {
 public:
  void add(Index v, Index w) {
    at_[v].push_back(w);
    at_[w].push_back(v);
  }

  std::size_t degree(Index v) const {
    const auto found = at_.find(v);
    return found == at_.end() ? 0 : found->second.size();
  }

  const std::map<Index, std::vector<Index>>& vertices() const { return at_; }

  /// Of one or more than two edges at both ends; then closed ones.
  std::vector<std::vector<Index>> chains(const Patch& patch) {
    std::vector<std::vector<Index>> chains;
    const auto ends_here = [&](Index v) { return degree(v) != 2 || patch.is_border(v); };
    for (const bool closed : {false, true}) {
      for (const auto& [v, others] : at_) {
        if (!closed && !ends_here(v)) continue;
        for (const Index w : others) {
          if (!take(v, w)) continue;
          std::vector<Index> chain = {v, w};
          while (!ends_here(chain.back()) && chain.back() != v) {
            const Index here = chain.back();
            const auto& next = at_.at(here);
            const Index on = next[0] == chain[chain.size() - 2] ? next[1] : next[0];
            take(here, on);
            chain.push_back(on);
          }
          chains.push_back(std::move(chain));
        }
      }
    }
    return chains;
  }

 private:
  bool take(Index v, Index w) {
    return taken_.emplace(std::pair{std::min(v, w), std::max(v, w)}, true).second;
  }

  std::map<Index, std::vector<Index>> at_;
  std::map<std::pair<Index, Index>, bool> taken_;
};

}  // namespace

std::vector<SurfaceLine> crease_lines(const Patch& patch, double least) {
  constexpr double degree = 0.017453292519943295, lower = 1.0 / 3.0;
  // Cosine of the largest turn with which a weaker edge leads on.
  constexpr double least_onward = 0.7;
  if (!(least > 0.0) || !std::isfinite(least))
    throw Error(ErrorCode::option_out_of_range, "the angle of creases must be above 0 degrees");
  const double scale = patch.unit_scale();
  const auto at = [&](Index v) { return scale * patch.positions()[v]; };
  EdgeChains edges;
  std::map<Index, std::vector<std::pair<double, Index>>> weaker;
  for (const Edge& edge : patch.edges()) {
    if (edge.is_border()) continue;
    const double angle =
        dihedral_angle(at(edge.from), at(edge.to), at(edge.left), at(edge.right)) / degree;
    if (angle >= least) {
      edges.add(edge.from, edge.to);
    } else if (angle >= lower * least) {
      weaker[edge.from].push_back({angle, edge.to});
      weaker[edge.to].push_back({angle, edge.from});
    }
  }
  std::vector<std::array<Index, 2>> ends;  // and the vertex before
  for (const auto& [v, others] : edges.vertices()) {
    if (others.size() == 1 && !patch.is_border(v)) ends.push_back({others[0], v});
  }
  for (auto [before, end] : ends) {
    while (!patch.is_border(end) && edges.degree(end) == 1) {
      const auto found = weaker.find(end);
      if (found == weaker.end()) break;
      const Vec3 along = at(end) - at(before);
      const std::pair<double, Index>* best = nullptr;
      for (const auto& candidate : found->second) {
        const Vec3 on = at(candidate.second) - at(end);
        if (dot(on, along) < least_onward * norm(on) * norm(along)) continue;
        if (best == nullptr || candidate.first > best->first) best = &candidate;
      }
      if (best == nullptr) break;
      const Index next = best->second;
      edges.add(end, next);
      before = std::exchange(end, next);
    }
  }
  std::vector<SurfaceLine> lines;
  for (const std::vector<Index>& chain : edges.chains(patch))
    lines.push_back(line_along_edges(patch, chain));
  return lines;
}

}  // namespace planish
