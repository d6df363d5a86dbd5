#include "cut/small_pieces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

namespace planish::cli {

namespace {

using Ends = std::array<Index, 2>;

Ends ends_of(Index v, Index w) {
  return {std::min(v, w), std::max(v, w)};
}

/// An edge, and one of the triangles that have it.
struct EdgeOfTriangle {
  Ends ends;
  Index triangle;
};

/// Pieces of a mesh between lines.
class Pieces {
 public:
  Pieces(const Patch& patch, std::span<const LinePath> paths) : patch_(patch) {
    for (const LinePath& path : paths) {
      for (std::size_t i = 1; i < path.vertices.size(); ++i)
        lines_[ends_of(path.vertices[i - 1], path.vertices[i])].push_back(path.line);
    }
    divide();
    measure();
  }

  std::size_t count() const { return area_.size(); }
  double share(std::size_t piece) const {
    return area_[piece] / std::accumulate(area_.begin(), area_.end(), 0.0);
  }

  /// Of the rectangle with its area and circumference, scaled.
  double width(std::size_t piece) const {
    const double quarter = 0.25 * around_[piece], root = quarter * quarter - area_[piece];
    return root > 0.0 ? quarter - std::sqrt(root) : quarter;
  }

  const std::map<std::array<std::size_t, 2>, double>& seams() const { return seams_; }

  /// The pieces on both sides of an edge of a line; nothing of one along the border.
  std::optional<std::array<std::size_t, 2>> beside(const Ends& ends) const {
    const auto found = beside_.find(ends);
    if (found == beside_.end()) return std::nullopt;
    return found->second;
  }

  /// Whether it has edges, and all of them are of the border.
  bool is_along_border(const std::vector<Index>& path) const {
    bool is = path.size() > 1;
    for (std::size_t i = 1; i < path.size(); ++i)
      is = is && !beside_.contains(ends_of(path[i - 1], path[i]));
    return is;
  }

  /// Whether there are two pieces at an edge of it.
  bool is_between(const std::vector<Index>& path) const {
    for (std::size_t i = 1; i < path.size(); ++i) {
      const auto pieces = beside(ends_of(path[i - 1], path[i]));
      if (pieces && (*pieces)[0] != (*pieces)[1]) return true;
    }
    return false;
  }

  std::vector<std::size_t> lines_around(std::size_t piece) const {
    std::vector<std::size_t> around;
    for (const auto& [ends, pieces] : beside_) {
      if (pieces[0] == pieces[1] || (pieces[0] != piece && pieces[1] != piece)) continue;
      for (const std::size_t line : lines_.at(ends)) {
        if (std::find(around.begin(), around.end(), line) == around.end()) around.push_back(line);
      }
    }
    std::sort(around.begin(), around.end());
    return around;
  }

 private:
  Vec3 at(Index v) const { return patch_.unit_scale() * patch_.positions()[v]; }

  Index first_of(Index t) {
    while (root_[t] != t)
      t = root_[t] = root_[root_[t]];
    return t;
  }

  void divide() {
    const auto& triangles = patch_.triangles();
    std::vector<EdgeOfTriangle> edges;
    edges.reserve(3 * triangles.size());
    for (Index t = 0; t < triangles.size(); ++t) {
      for (std::size_t k = 0; k < 3; ++k)
        edges.push_back({ends_of(triangles[t][k], triangles[t][(k + 1) % 3]), t});
    }
    std::sort(edges.begin(), edges.end(), [](const EdgeOfTriangle& a, const EdgeOfTriangle& b) {
      return std::pair(a.ends, a.triangle) < std::pair(b.ends, b.triangle);
    });
    root_.resize(triangles.size());
    std::iota(root_.begin(), root_.end(), Index{0});
    std::vector<std::pair<Ends, std::array<Index, 2>>> cut;
    for (std::size_t e = 1; e < edges.size(); ++e) {
      const EdgeOfTriangle &a = edges[e - 1], &b = edges[e];
      if (a.ends != b.ends) continue;
      if (lines_.contains(a.ends)) {
        cut.emplace_back(a.ends, std::array{a.triangle, b.triangle});
        continue;
      }
      const Index one = first_of(a.triangle), other = first_of(b.triangle);
      root_[std::max(one, other)] = std::min(one, other);
    }
    // As split() has it: by their first triangles.
    piece_of_.resize(triangles.size());
    for (Index t = 0; t < triangles.size(); ++t) {
      const Index first = first_of(t);
      piece_of_[t] = first == t ? area_.size() : piece_of_[first];
      if (first == t) area_.push_back(0.0);
    }
    for (const auto& [ends, sides] : cut)
      beside_[ends] = {piece_of_[sides[0]], piece_of_[sides[1]]};
  }

  void measure() {
    around_.assign(area_.size(), 0.0);
    const auto& triangles = patch_.triangles();
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      const auto& [a, b, c] = triangles[t];
      area_[piece_of_[t]] += 0.5 * norm(cross(at(b) - at(a), at(c) - at(a)));
      for (const auto& [v, w] : {std::pair{a, b}, std::pair{b, c}, std::pair{c, a}}) {
        const auto ring = patch_.ring(v);
        const bool is_border =
            patch_.is_border(v) && patch_.is_border(w) && (ring.front() == w || ring.back() == w);
        if (is_border) around_[piece_of_[t]] += norm(at(w) - at(v));
      }
    }
    for (const auto& [ends, pieces] : beside_) {
      const double length = norm(at(ends[1]) - at(ends[0]));
      around_[pieces[0]] += length;
      around_[pieces[1]] += length;
      if (pieces[0] == pieces[1]) continue;
      seams_[{std::min(pieces[0], pieces[1]), std::max(pieces[0], pieces[1])}] += length;
    }
  }

  const Patch& patch_;
  std::map<Ends, std::vector<std::size_t>> lines_;
  std::vector<Index> root_;
  std::vector<std::size_t> piece_of_;
  std::vector<double> area_, around_;
  std::map<Ends, std::array<std::size_t, 2>> beside_;
  std::map<std::array<std::size_t, 2>, double> seams_;
};

/// Which piece each became a part of.
class Groups {
 public:
  explicit Groups(const Pieces& pieces) : pieces_(pieces), group_(pieces.count()) {
    std::iota(group_.begin(), group_.end(), std::size_t{0});
  }

  std::size_t of(std::size_t piece) const {
    while (group_[piece] != piece)
      piece = group_[piece];
    return piece;
  }

  /// The neighbour with the longest seam, all that it was joined with included.
  std::optional<std::size_t> neighbour(std::size_t piece) const {
    std::map<std::size_t, double> lengths;
    for (const auto& [two, length] : pieces_.seams()) {
      const std::size_t a = of(two[0]), b = of(two[1]);
      if (a != b && (a == of(piece) || b == of(piece))) lengths[a == of(piece) ? b : a] += length;
    }
    std::optional<std::size_t> best;
    for (const auto& [other, length] : lengths) {
      if (!best || length > lengths.at(*best)) best = other;
    }
    return best;
  }

  void join(std::size_t piece, std::size_t to) { group_[of(piece)] = of(to); }

 private:
  const Pieces& pieces_;
  std::vector<std::size_t> group_;
};

}  // namespace

KeptPaths without_small_pieces(const Patch& patch, std::span<const LinePath> paths,
                               const SmallLimits& limits) {
  const Pieces pieces(patch, paths);
  std::vector<std::size_t> small;
  for (std::size_t p = 0; p < pieces.count(); ++p) {
    const bool is_narrow =
        pieces.share(p) < limits.narrow_area && pieces.width(p) < patch.unit_scale() * limits.width;
    if (is_narrow || pieces.share(p) < limits.area) small.push_back(p);
  }
  std::stable_sort(small.begin(), small.end(),
                   [&](std::size_t a, std::size_t b) { return pieces.share(a) < pieces.share(b); });
  KeptPaths kept;
  Groups groups(pieces);
  std::vector<unsigned char> is_small(pieces.count(), 0);
  for (const std::size_t p : small) {
    const auto neighbour = groups.neighbour(p);
    if (!neighbour) continue;
    groups.join(p, *neighbour);
    is_small[p] = 1;
    kept.small.push_back({p, pieces.share(p), *neighbour, pieces.lines_around(p)});
  }
  // Of lines inside a piece those of small ones go too: there may be nothing left that they meet.
  const auto is_cut = [&](Index v, Index w) {
    const auto beside = pieces.beside(ends_of(v, w));
    if (!beside) return false;
    const auto [a, b] = *beside;
    return a == b ? is_small[a] == 0 : groups.of(a) != groups.of(b);
  };
  for (const LinePath& path : paths) {
    if (!pieces.is_between(path.vertices)) kept.inside.push_back(path.line);
    if (pieces.is_along_border(path.vertices)) kept.paths.push_back(path);
    std::vector<Index> run;
    for (std::size_t i = 1; i <= path.vertices.size(); ++i) {
      const bool goes_on =
          i < path.vertices.size() && is_cut(path.vertices[i - 1], path.vertices[i]);
      if (goes_on && run.empty()) run.push_back(path.vertices[i - 1]);
      if (goes_on) run.push_back(path.vertices[i]);
      if (!goes_on && !run.empty()) kept.paths.push_back({std::exchange(run, {}), path.line});
    }
  }
  return kept;
}

}  // namespace planish::cli
