#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include <planish/mesh/seams.h>

#include "mesh/match/borders.h"

namespace planish {

namespace {

using Pair = std::pair<std::size_t, std::size_t>;  // of border edges at one place, the lower first

/// Numbers places in space: the same number for what is at the same one.
class PlaceNumbers {
 public:
  explicit PlaceNumbers(double tolerance) : tolerance_(tolerance) {}

  std::size_t number_of(Vec3 p) {
    const Cell cell = cell_of(p);
    if (tolerance_ > 0.0) {
      if (const auto near = nearest(p, cell)) return *near;
    } else if (const auto found = cells_.find(cell); found != cells_.end()) {
      return found->second.front();
    }
    places_.push_back(p);
    cells_[cell].push_back(places_.size() - 1);
    return places_.size() - 1;
  }

 private:
  using Cell = std::array<double, 3>;

  /// The coordinates themselves where they are to be equal.
  Cell cell_of(Vec3 p) const {
    if (!(tolerance_ > 0.0)) return {p.x, p.y, p.z};
    return {std::floor(p.x / tolerance_), std::floor(p.y / tolerance_),
            std::floor(p.z / tolerance_)};
  }

  std::optional<std::size_t> nearest(Vec3 p, const Cell& cell) const {
    std::optional<std::size_t> best;
    double best_distance = tolerance_;
    for (int k = 0; k < 27; ++k) {
      const int row = k / 3 % 3, layer = k / 9;
      const Cell there = {cell[0] + k % 3 - 1, cell[1] + row - 1, cell[2] + layer - 1};
      const auto found = cells_.find(there);
      if (found == cells_.end()) continue;
      for (const std::size_t place : found->second) {
        const double distance = norm(places_[place] - p);
        if (distance > best_distance || (best && distance == best_distance)) continue;
        best = place;
        best_distance = distance;
      }
    }
    return best;
  }

  double tolerance_;
  std::vector<Vec3> places_;
  std::map<Cell, std::vector<std::size_t>> cells_;
};

/// The place where each border edge begins.
std::vector<std::size_t> starts_of(const std::vector<BorderEdge>& borders,
                                   std::span<const TriMesh> patches, double tolerance) {
  PlaceNumbers places(tolerance);
  std::vector<std::size_t> starts;
  starts.reserve(borders.size());
  for (const BorderEdge& edge : borders)
    starts.push_back(places.number_of(patches[edge.patch].positions[edge.from]));
  return starts;
}

/// Which border edges lie at one place, two by two.
std::set<Pair> edges_at_one_place(const std::vector<BorderEdge>& borders,
                                  const std::vector<std::size_t>& starts) {
  std::map<Pair, std::vector<std::size_t>> edges_at;
  std::set<Pair> pairs;
  for (std::size_t e = 0; e < borders.size(); ++e) {
    const std::size_t a = starts[e], b = starts[borders[e].next];
    if (a == b) continue;  // shorter than the tolerance
    std::vector<std::size_t>& here = edges_at[std::minmax(a, b)];
    for (const std::size_t other : here)
      pairs.insert({other, e});
    here.push_back(e);
  }
  return pairs;
}

/// The pairs of edges put together to curves.
class SeamWalk {
 public:
  SeamWalk(std::span<const TriMesh> patches, double tolerance)
      : borders_(border_edges(patches)),
        starts_(starts_of(borders_, patches, tolerance)),
        left_(edges_at_one_place(borders_, starts_)) {}

  std::vector<Seam> walk() {
    std::vector<Seam> seams;
    while (!left_.empty())
      seams.push_back(take(*left_.begin()));
    std::stable_sort(seams.begin(), seams.end(), [](const Seam& a, const Seam& b) {
      return Pair(a.sides[0].patch, a.sides[1].patch) < Pair(b.sides[0].patch, b.sides[1].patch);
    });
    return seams;
  }

 private:
  const BorderEdge& edge(std::size_t e) const { return borders_[e]; }

  /// Whether the second border goes the other way, as it does where both have the same side out.
  bool is_reversed(Pair pair) const { return starts_[pair.first] != starts_[pair.second]; }

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

  Seam take(Pair pair) {
    const Pair begin = pair;
    while (const auto before = step(pair, false)) {
      pair = *before;
      if (pair == begin) break;  // it is closed
    }
    Seam seam;
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
      at = step(pair, true);
    }
    return seam;
  }

  std::vector<BorderEdge> borders_;
  std::vector<std::size_t> starts_;
  std::set<Pair> left_;  // not in a seam yet
};

template <class Point>
double polyline_length(const std::vector<Index>& vertices, std::span<const Point> points) {
  double length = 0.0;
  for (std::size_t k = 1; k < vertices.size(); ++k)
    length += norm(points[vertices[k]] - points[vertices[k - 1]]);
  return length;
}

}  // namespace

std::vector<Seam> find_seams(std::span<const TriMesh> patches, double tolerance) {
  return SeamWalk(patches, tolerance).walk();
}

double length_of(const SeamSide& side, std::span<const Vec3> positions) {
  return polyline_length(side.vertices, positions);
}

double length_of(const SeamSide& side, std::span<const Vec2> pattern) {
  return polyline_length(side.vertices, pattern);
}

}  // namespace planish
