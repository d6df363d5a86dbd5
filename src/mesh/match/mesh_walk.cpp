#include "mesh/match/mesh_walk.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <planish/core/error.h>

#include "geometry/curve_size.h"

namespace planish {

namespace {

constexpr Index k_none = static_cast<Index>(-1);

/// True also for what is no number.
bool differ(double a, double b, double tolerance) {
  return !(std::abs(a - b) <= tolerance);
}

class Walk {
 public:
  Walk(const WalkedMesh& first, const WalkedMesh& second, bool mirrored, double tolerance,
       WalkBudget& budget)
      : first_(first),
        second_(second),
        mirrored_(mirrored),
        tolerance_(tolerance),
        budget_(budget),
        pair_(first.positions.size(), k_none),
        reached_from_(first.positions.size(), k_none),
        taken_(second.positions.size(), 0) {}

  std::optional<std::vector<Index>> from(Index v, Index w) {
    if (!join(v, w, k_none)) return std::nullopt;
    std::size_t done = 0;
    while (done < queue_.size()) {  // which grows
      if (!pair_neighbours(queue_[done++])) return std::nullopt;
    }
    if (queue_.size() != pair_.size()) return std::nullopt;
    return std::move(pair_);
  }

 private:
  /// Pairs two vertices, or confirms that they are a pair.
  bool join(Index v, Index w, Index reached_from) {
    if (pair_[v] != k_none) return pair_[v] == w;
    const Connectivity &a = first_.connectivity, &b = second_.connectivity;
    if (taken_[w] != 0 || a.ring(v).size() != b.ring(w).size()) return false;
    if (a.is_border(v) != b.is_border(w)) return false;
    pair_[v] = w;
    taken_[w] = 1;
    reached_from_[v] = reached_from;
    queue_.push_back(v);
    return true;
  }

  bool pair_neighbours(Index v) {
    const Index w = pair_[v];
    const auto ring = first_.connectivity.ring(v), other = second_.connectivity.ring(w);
    const std::size_t n = ring.size();
    if (!budget_.take(n)) return false;
    std::size_t begin = 0, begin_other = mirrored_ ? n - 1 : 0;  // of an open ring
    if (!first_.connectivity.is_border(v)) {
      begin = place_in(ring, reached_from_[v]);
      begin_other = place_in(other, pair_[reached_from_[v]]);
      if (begin_other == n) return false;
    }
    for (std::size_t j = 0; j < n; ++j) {
      const Index u = ring[(begin + j) % n];
      const Index x = other[(begin_other + (mirrored_ ? n - j : j)) % n];
      if (differ(norm(first_.positions[u] - first_.positions[v]),
                 norm(second_.positions[x] - second_.positions[w]), tolerance_)) {
        return false;
      }
      if (!join(u, x, v)) return false;
    }
    return true;
  }

  static std::size_t place_in(std::span<const Index> ring, Index v) {
    return static_cast<std::size_t>(std::find(ring.begin(), ring.end(), v) - ring.begin());
  }

  const WalkedMesh &first_, &second_;
  bool mirrored_;
  double tolerance_;
  WalkBudget& budget_;
  std::vector<Index> pair_, reached_from_;
  std::vector<unsigned char> taken_;
  std::vector<Index> queue_;
};

/// Whether the whole borders correspond from there: most wrong starts end here, after few edges.
bool borders_correspond(const WalkedMesh& first, const WalkedMesh& second, bool mirrored,
                        std::size_t start, double tolerance, WalkBudget& budget) {
  const auto border = first.border(), other = second.border();
  const std::size_t n = border.size();
  for (std::size_t i = 0; i < n; ++i) {
    if (!budget.take(1)) return false;
    const std::size_t at = (start + (mirrored ? n - i : i)) % n;
    const std::size_t edge = mirrored ? (at + n - 1) % n : at;
    if (first.connectivity.ring(border[i]).size() != second.connectivity.ring(other[at]).size())
      return false;
    if (differ(first.border_lengths[i], second.border_lengths[edge], tolerance)) return false;
  }
  return true;
}

}  // namespace

std::optional<WalkedMesh> walked_mesh(const TriMesh& mesh) {
  auto connectivity = Connectivity::build(mesh);
  if (!connectivity) return std::nullopt;
  WalkedMesh walked{unit_scale(mesh), mesh.positions, *std::move(connectivity)};
  const auto& loops = walked.connectivity.border_loops();
  if (loops.empty()) return std::nullopt;
  walked.outer = outer_loop(sizes_of_loops(mesh.positions, loops, walked.scale));
  for (Vec3& p : walked.positions)
    p = walked.scale * p;
  const auto border = walked.border();
  walked.border_lengths.reserve(border.size());
  for (std::size_t i = 0; i < border.size(); ++i) {
    const Index v = border[i], w = border[(i + 1) % border.size()];
    walked.border_lengths.push_back(norm(walked.positions[w] - walked.positions[v]));
    walked.perimeter += walked.border_lengths.back();
  }
  return walked;
}

WalkedMesh rescaled(WalkedMesh mesh, double scale) {
  const double factor = scale / mesh.scale;
  for (Vec3& p : mesh.positions)
    p = factor * p;
  for (double& length : mesh.border_lengths)
    length *= factor;
  mesh.perimeter *= factor;
  mesh.scale = scale;
  return mesh;
}

std::optional<std::vector<Index>> walk_both(const WalkedMesh& first, const WalkedMesh& second,
                                            bool mirrored, std::size_t start, double tolerance,
                                            WalkBudget& budget) {
  if (!borders_correspond(first, second, mirrored, start, tolerance, budget)) return std::nullopt;
  if (!budget.take(first.positions.size())) return std::nullopt;
  return Walk(first, second, mirrored, tolerance, budget)
      .from(first.border().front(), second.border()[start]);
}

}  // namespace planish
