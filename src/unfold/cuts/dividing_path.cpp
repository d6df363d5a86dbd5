#include "unfold/cuts/dividing_path.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include <planish/mesh/cut.h>

#include "geometry/crosses_itself.h"
#include "mesh/border_loops.h"
#include "mesh/cut/inside_paths.h"

namespace planish {

namespace {

constexpr std::size_t k_places = 24;       // on the outline from which paths are tried
constexpr std::size_t k_crossings = 1000;  // that are looked at
constexpr double k_least_part = 0.03;      // of the outline that a path takes off

using Crossings = std::vector<std::pair<std::size_t, std::size_t>>;

const std::vector<Index>& outline_of(const Patch& patch) {
  const BorderKinds kinds =
      border_kinds(patch.positions(), patch.connectivity(), patch.unit_scale());
  return patch.border_loops()[kinds.outline];
}

/// Where a path divides best.
struct Division {
  double cost = std::numeric_limits<double>::infinity();
  std::size_t from = 0, to = 0;  // of the outline
};

class Divider {
 public:
  Divider(const Patch& patch, std::span<const Vec2> pattern, std::span<const double> weights)
      : outline_(outline_of(patch)), paths_(patch, weights) {
    const double scale = patch.unit_scale();
    for (std::size_t k = 0; k <= outline_.size(); ++k) {
      const Index v = outline_[k % outline_.size()];
      const Index before = outline_[(k + outline_.size() - 1) % outline_.size()];
      const double step = norm(scale * patch.positions()[v] - scale * patch.positions()[before]);
      along_.push_back(k == 0 ? 0.0 : along_.back() + step);
    }
    if (pattern.empty()) return;
    std::vector<Vec2> line;
    line.reserve(outline_.size());
    for (const Index v : outline_)
      line.push_back(pattern[v]);
    crossings_ = crossing_sides(line, k_crossings);
  }

  std::optional<std::vector<Index>> best() {
    Division best;
    const std::size_t count = std::min(k_places, outline_.size());
    for (std::size_t k = 0; k < count; ++k) {
      const double at = along_.back() * static_cast<double>(k) / static_cast<double>(count);
      const auto found = std::lower_bound(along_.begin(), along_.end(), at);
      look_from(static_cast<std::size_t>(found - along_.begin()) % outline_.size(), best);
    }
    if (!std::isfinite(best.cost)) return std::nullopt;
    const Index from = outline_[best.from], to = outline_[best.to];
    return paths_.from(std::span(&from, 1), [&](Index v) { return v == to; });
  }

 private:
  /// How many crossings a path from one place of the outline to each other one undoes.
  std::vector<std::ptrdiff_t> undone_from(std::size_t from) const {
    const std::size_t n = outline_.size();
    std::vector<std::ptrdiff_t> change(n + 1, 0);
    for (const auto& [one, other] : crossings_) {
      const std::size_t a = (one + n - from) % n, b = (other + n - from) % n;
      // The sides begin at a and b: what ends behind the first and not behind the other.
      ++change[std::min(a, b) + 1];
      --change[std::max(a, b) + 1];
    }
    for (std::size_t k = 1; k <= n; ++k)
      change[k] += change[k - 1];
    return change;
  }

  void look_from(std::size_t from, Division& best) {
    const std::size_t n = outline_.size();
    const InsidePaths::Tree tree = paths_.tree(std::span(&outline_[from], 1));
    const std::vector<std::ptrdiff_t> undone = undone_from(from);
    for (std::size_t k = 2; k + 1 < n; ++k) {
      const std::size_t to = (from + k) % n;
      double part = std::abs(along_[to] - along_[from]);
      part = std::min(part, along_.back() - part);
      const double apart = crossings_.empty() ? 1.0
                                              : static_cast<double>(undone[k]) /
                                                    static_cast<double>(crossings_.size());
      if (part < k_least_part * along_.back() || apart <= 0.0) continue;
      const double cost = tree.distance[outline_[to]] / (part * apart);
      if (cost < best.cost) best = {cost, from, to};
    }
  }

  const std::vector<Index>& outline_;
  InsidePaths paths_;
  std::vector<double> along_;  // the outline, to each vertex and all around
  Crossings crossings_;
};

}  // namespace

std::optional<std::vector<Index>> dividing_path(const Patch& patch, std::span<const Vec2> pattern,
                                                std::span<const double> weights) {
  return Divider(patch, pattern, weights).best();
}

}  // namespace planish
