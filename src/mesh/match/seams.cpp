#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include <planish/mesh/seams.h>

#include "mesh/match/border_lines.h"
#include "mesh/match/curve_seams.h"

namespace planish {

namespace {

using Pair = std::pair<std::size_t, std::size_t>;  // of border edges at one place, the lower first

/// Vertices of borders that are equal, by the edges that begin there.
class EqualVertices {
 public:
  EqualVertices(const BorderLines& borders, std::span<const BoundaryCorrespondence> correspondences,
                double tolerance) {
    for (const BoundaryCorrespondence& two : correspondences) {
      const auto edge = [&](std::size_t side) {
        return borders.edge_at(borders.loops()[two.loops[side]], two.at[side]);
      };
      const Pair edges = {edge(0), edge(1)};
      const bool at_vertices =
          two.at[0] == std::floor(two.at[0]) && two.at[1] == std::floor(two.at[1]);
      const double distance = norm(borders.start(edges.first) - borders.start(edges.second));
      if (!at_vertices || distance > tolerance) continue;
      pairs_.insert(edges);
      pairs_.insert({edges.second, edges.first});
    }
  }

  bool has(std::size_t a, std::size_t b) const { return a == b || pairs_.count({a, b}) > 0; }

  /// Which border edges lie at one place, two by two.
  std::set<Pair> edges(const std::vector<BorderEdge>& borders) const {
    std::set<Pair> found;
    for (const auto& [a, b] : pairs_) {
      const std::size_t before = borders[b].previous;
      if (has(borders[a].next, borders[b].next)) found.insert(std::minmax(a, b));
      if (has(borders[a].next, before) && a != before) found.insert(std::minmax(a, before));
    }
    return found;
  }

 private:
  std::set<Pair> pairs_;
};

/// A seam with equal vertices on both sides, and the pairs of edges that it is made of.
struct VertexSeam {
  Seam seam;
  std::vector<Pair> pairs;
};

/// The pairs of edges put together to curves.
class SeamWalk {
 public:
  SeamWalk(const std::vector<BorderEdge>& borders, EqualVertices equal)
      : borders_(borders), equal_(std::move(equal)), left_(equal_.edges(borders)) {}

  std::vector<VertexSeam> walk() {
    std::vector<VertexSeam> seams;
    while (!left_.empty())
      seams.push_back(take(*left_.begin()));
    return seams;
  }

 private:
  const BorderEdge& edge(std::size_t e) const { return borders_[e]; }

  /// Whether the second border goes the other way, as it does where both have the same side out.
  bool is_reversed(Pair pair) const { return !equal_.has(pair.first, pair.second); }

  std::optional<Pair> step(Pair pair, bool forward) const {
    const bool reversed = is_reversed(pair);
    const auto along = [&](std::size_t e, bool ahead) {
      return ahead ? edge(e).next : edge(e).previous;
    };
    const Pair to = {along(pair.first, forward), along(pair.second, forward != reversed)};
    // Past the tip of a dart the two sides have changed their parts.
    const bool goes_on = left_.count(to) > 0 && is_reversed(to) == reversed &&
                         edge(to.first).patch == edge(pair.first).patch;
    return goes_on ? std::optional(to) : std::nullopt;
  }

  VertexSeam take(Pair pair) {
    const Pair begin = pair;
    while (const auto before = step(pair, false)) {
      pair = *before;
      if (pair == begin) break;  // it is closed
    }
    VertexSeam found;
    Seam& seam = found.seam;
    seam.sides[0].patch = edge(pair.first).patch;
    seam.sides[1].patch = edge(pair.second).patch;
    const bool reversed = is_reversed(pair);
    const auto second = [&](bool end) {
      const BorderEdge& e = edge(pair.second);
      return end == reversed ? e.from : e.to;
    };
    seam.sides[0].vertices.push_back(edge(pair.first).from);
    seam.sides[1].vertices.push_back(second(false));
    for (std::optional<Pair> at = pair; at;) {
      pair = *at;
      seam.sides[0].vertices.push_back(edge(pair.first).to);
      seam.sides[1].vertices.push_back(second(true));
      left_.erase(pair);
      found.pairs.push_back(pair);
      at = step(pair, true);
    }
    return found;
  }

  const std::vector<BorderEdge>& borders_;
  EqualVertices equal_;
  std::set<Pair> left_;  // not in a seam yet
};

using Patches = std::pair<std::size_t, std::size_t>;

Patches patches_of(const Seam& seam) {
  return {seam.sides[0].patch, seam.sides[1].patch};
}

/// Seams with equal vertices, and seams as curves where those leave a curve matched in part.
class SeamChoice {
 public:
  SeamChoice(const BorderLines& borders, std::vector<VertexSeam> seams)
      : borders_(borders), sewn_(borders.edges().size(), false) {
    for (VertexSeam& seam : seams) {
      const std::size_t first = std::min_element(seam.pairs.begin(), seam.pairs.end())->first;
      for (const Pair& pair : seam.pairs)
        sewn_[pair.first] = sewn_[pair.second] = true;
      ExactSeams& exact = by_patches_[patches_of(seam.seam)];
      for (const Pair& pair : seam.pairs) {
        exact.at_edge[pair.first].push_back(exact.seams.size());
        exact.at_edge[pair.second].push_back(exact.seams.size());
      }
      exact.seams.push_back({first, std::move(seam), true});
    }
  }

  void add(CurveSeam curve) {
    ExactSeams& exact = by_patches_[patches_of(curve.seam)];
    const Overlap overlap = overlap_of(curve, exact);
    if (!overlap.is_any() && is_sewn(curve.edges[0]) && is_sewn(curve.edges[1])) return;
    // It runs past a dart in one side, whose legs are a seam of their own.
    if (is_sewn(curve.edges[0], 1.0) && is_sewn(curve.edges[1], 1.0)) return;
    const bool divides_it = overlap.inside.size() > 1 && !overlap.has_other;
    if (overlap.is_any() && !divides_it && !leaves_a_seam(curve, overlap.matched)) return;
    for (Exact* other : overlap.inside)
      other->is_kept = false;
    drop_strays(exact);
    const std::size_t first = *std::min_element(curve.edges[0].begin(), curve.edges[0].end());
    curves_.push_back({first, std::move(curve.seam)});
  }

  std::vector<Seam> seams() {
    std::vector<Placed> all = std::move(curves_);
    for (auto& [patches, exact] : by_patches_) {
      for (Exact& seam : exact.seams)
        if (seam.is_kept) all.push_back({seam.first, std::move(seam.found.seam)});
    }
    std::stable_sort(all.begin(), all.end(), [](const Placed& a, const Placed& b) {
      return std::pair(patches_of(a.seam), a.first) < std::pair(patches_of(b.seam), b.first);
    });
    std::vector<Seam> seams;
    seams.reserve(all.size());
    for (Placed& placed : all)
      seams.push_back(std::move(placed.seam));
    return seams;
  }

 private:
  struct Placed {
    std::size_t first;  // edge of the first side
    Seam seam;
  };
  struct Exact {
    std::size_t first;
    VertexSeam found;
    bool is_kept;
  };
  /// Those of two patches.
  struct ExactSeams {
    std::vector<Exact> seams;
    std::map<std::size_t, std::vector<std::size_t>> at_edge;  // numbers of the seams on it
    bool has_no_strays = false;
  };

  void drop_strays(ExactSeams& exact) const {
    if (exact.has_no_strays) return;
    for (Exact& seam : exact.seams)
      seam.is_kept = seam.is_kept && !is_stray(seam.found);
    exact.has_no_strays = true;
  }

  /// Whether enough of the edges are in seams with equal vertices: where nearly all are, what lies
  /// beside them is another layer.
  bool is_sewn(const std::vector<std::size_t>& edges, double share = 0.9) const {
    const auto count =
        std::count_if(edges.begin(), edges.end(), [&](std::size_t edge) { return sewn_[edge]; });
    return static_cast<double>(count) >= share * static_cast<double>(edges.size());
  }

  /// Seams with equal vertices along a curve.
  struct Overlap {
    std::vector<Exact*> inside;     // with half of their edges or more
    bool has_other = false;         // with less
    std::set<std::size_t> matched;  // edges of both sides

    bool is_any() const { return has_other || !inside.empty(); }
  };

  static Overlap overlap_of(const CurveSeam& curve, ExactSeams& exact) {
    const std::set<std::size_t> first(curve.edges[0].begin(), curve.edges[0].end());
    const std::set<std::size_t> second(curve.edges[1].begin(), curve.edges[1].end());
    const auto is_inside = [&](const Pair& pair) {
      return (first.count(pair.first) > 0 && second.count(pair.second) > 0) ||
             (first.count(pair.second) > 0 && second.count(pair.first) > 0);
    };
    std::set<std::size_t> along;
    for (const std::vector<std::size_t>& side : curve.edges) {
      for (const std::size_t edge : side) {
        const auto found = exact.at_edge.find(edge);
        if (found != exact.at_edge.end()) along.insert(found->second.begin(), found->second.end());
      }
    }
    Overlap overlap;
    for (const std::size_t number : along) {
      Exact& other = exact.seams[number];
      const std::vector<Pair>& pairs = other.found.pairs;
      const auto count =
          static_cast<std::size_t>(std::count_if(pairs.begin(), pairs.end(), is_inside));
      if (count == 0 || !other.is_kept) continue;
      if (2 * count >= pairs.size())
        overlap.inside.push_back(&other);
      else
        overlap.has_other = true;
      for (const Pair& pair : pairs)
        overlap.matched.insert({pair.first, pair.second});
    }
    return overlap;
  }

  /// Whether a few vertices only happen to lie at the same places, of patches meshed apart.
  bool is_stray(const VertexSeam& seam) const {
    constexpr std::size_t k_fewest = 5;
    constexpr double k_shortest = 0.01;  // of the shorter border
    double length = 0.0;
    for (const Pair& pair : seam.pairs)
      length += borders_.length(pair.first);
    const auto [first, second] = seam.pairs.front();
    const double border = std::min(borders_.loop_of(first).length, borders_.loop_of(second).length);
    return seam.pairs.size() < k_fewest && length < k_shortest * border;
  }

  /// Whether a stretch of the curve that is not matched by vertices could be a seam.
  bool leaves_a_seam(const CurveSeam& curve, const std::set<std::size_t>& matched) const {
    const std::array<const BorderLoop*, 2> loops = {&borders_.loop_of(curve.edges[0].front()),
                                                    &borders_.loop_of(curve.edges[1].front())};
    for (const std::vector<std::size_t>& side : curve.edges) {
      double length = 0.0;
      std::size_t edges = 0;
      for (const std::size_t edge : side) {
        const bool is_matched = matched.count(edge) > 0;
        length = is_matched ? 0.0 : length + borders_.length(edge);
        edges = is_matched ? 0 : edges + 1;
        if (!is_fragment(loops, {length, length}, {edges, edges})) return true;
      }
    }
    return false;
  }

  const BorderLines& borders_;
  std::vector<bool> sewn_;  // of each edge, in a seam with equal vertices
  std::map<Patches, ExactSeams> by_patches_;
  std::vector<Placed> curves_;
};

}  // namespace

std::vector<Seam> find_seams(std::span<const TriMesh> patches, double tolerance) {
  const BorderLines borders(patches);
  if (borders.edges().empty()) return {};
  auto correspondences = find_boundary_correspondences(borders, tolerance);
  const EqualVertices equal(borders, correspondences, vertex_tolerance(borders, tolerance));
  SeamChoice choice(borders, SeamWalk(borders.edges(), equal).walk());
  for (CurveSeam& curve : find_curve_seams(borders, std::move(correspondences), tolerance))
    choice.add(std::move(curve));
  return choice.seams();
}

}  // namespace planish
