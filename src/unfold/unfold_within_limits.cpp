#include "unfold/unfold_within_limits.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "unfold/strain/strain_of_edges.h"
#include "unfold/stretch/bounded_stretch.h"
#include "unfold/stretch/flat_edges.h"
#include "unfold/stretch/seam_system.h"

namespace planish {

namespace {

constexpr double k_infinity = std::numeric_limits<double>::infinity();

// Bounds are aimed at a little below the limit, so that a pattern at its bounds keeps it.
constexpr double k_within = 0.999;
// The share of the area on which p99 does not ask for anything; a little less is made use of.
constexpr double k_asked = 0.99, k_freed = 0.0099;
constexpr int k_most_p99_rounds = 4;
// Edges that are freed from the limit may have this multiple of it, or the most that any has
// without.
constexpr double k_freed_limits = 3.0;
// What stands for no bound: an edge a million times as long.
constexpr double k_unbounded = 1e6;
// A largest strain that no cutter or cloth would tell from none: left as it is.
constexpr double k_no_strain = 1e-6;

double largest(const std::vector<double>& strains) {
  double most = 0.0;
  for (const double strain : strains)
    most = std::max(most, std::abs(strain));
  return most;
}

/// The size of a strain in units of the bound for longer edges: what uses up as much of its bound
/// counts alike.
double weighed(double strain, const EdgeBounds& bounds) {
  return strain < 0.0 ? -strain / bounds.ratio() : strain;
}

std::vector<double> all_weighed(std::vector<double> strains, const EdgeBounds& bounds) {
  for (double& strain : strains)
    strain = weighed(strain, bounds);
  return strains;
}

double smaller_limit(double both, double one) {
  double limit = k_unbounded;
  for (const double given : {both, one}) {
    if (given > 0.0) limit = std::min(limit, given);
  }
  return limit;
}

/// What the limits say of edges: of all, and of those on 99 % of the area.
struct LimitsOfEdges {
  EdgeBounds all, area;

  explicit LimitsOfEdges(const StrainLimits& limits)
      : all{smaller_limit(limits.max, limits.max_compression),
            smaller_limit(limits.max, limits.max_stretch)},
        area{std::min(smaller_limit(limits.p99, limits.p99_compression), all.longer),
             std::min(smaller_limit(limits.p99, limits.p99_stretch), all.shorter)} {}

  /// Whether some edges may have more than others.
  bool differ() const { return area.longer < all.longer || area.shorter < all.shorter; }
};

/// How much of the limit is used up of which that share is largest: above 1 beyond it.
double largest_share(const StrainLimits& limits, const EdgeStrain& strain) {
  double share = 0.0;
  for (const LimitCheck& check : check_limits(strain, limits)) {
    if (check.what != Criterion::rms_strain) share = std::max(share, check.value / check.limit);
  }
  return share;
}

/// Runs the bounded solver once or more, and counts steps over all runs.
class LimitedUnfolding {
 public:
  LimitedUnfolding(const TriMesh& mesh, const Disk& disk, const HeldBorder* border,
                   int max_iterations, ThreadPool& pool, const std::function<void()>& after_step,
                   int iterations)
      : disk_(disk),
        border_(border),
        edges_(flat_edges(mesh, disk)),
        is_held_(held_edges()),
        max_iterations_(max_iterations),
        pool_(pool),
        after_step_(after_step),
        iterations_(iterations) {}

  const std::vector<FlatEdge>& edges() const { return edges_; }
  int iterations() const { return iterations_; }

  /// @param bounds idle for edges that keep their length
  BoundedStretch run(std::vector<EdgeBounds> bounds, std::vector<Vec2> start, BoundedAims aims) {
    aims.max_iterations = max_iterations_;
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      if (is_held_[e] != 0) bounds[e] = {k_infinity, k_infinity};
    }
    const auto system = make_system(disk_, border_, pool_);
    return minimise_stretch_within(disk_, *system, edges_, bounds, std::move(start), aims, [&] {
      ++iterations_;
      if (after_step_) after_step_();
    });
  }

  /// Every edge within the limit, or as near to that as it gets.
  BoundedStretch keep(const EdgeBounds& limit, std::vector<Vec2> start) {
    return run(std::vector<EdgeBounds>(edges_.size(), limit), std::move(start), aims());
  }

  /// Edges of 99 % of the area within a limit: all of them, or else all but those that have most
  /// strain, chosen anew where the pattern has changed. These keep the limit of all edges.
  BoundedStretch keep_on_99_percent(const LimitsOfEdges& limits, const std::vector<Vec2>& start) {
    const EdgeBounds& limit = limits.area;
    BoundedStretch best = keep(limit, start);
    double best_p99 = weighed_p99(best.flat, limit);
    const double freed = std::max(k_freed_limits * limit.longer,
                                  largest(all_weighed(strains_of(edges_, start), limit)));
    const EdgeBounds most = {std::min(freed, limits.all.longer),
                             std::min(freed * limit.ratio(), limits.all.shorter)};
    std::vector<Vec2> flat = start;
    for (int round = 0; round < k_most_p99_rounds && best_p99 > limit.longer; ++round) {
      const auto bounds = with_worst_freed(limit, strains_of(edges_, flat), most);
      BoundedStretch found = run(bounds, flat, aims());
      flat = found.flat;
      const double p99 = weighed_p99(flat, limit);
      if (p99 >= best_p99) continue;
      best = std::move(found);
      best_p99 = p99;
    }
    return best;
  }

 private:
  static BoundedAims aims() { return {.least_scale = k_within}; }

  std::vector<char> held_edges() const {
    std::vector<char> is_held(edges_.size(), 0);
    if (border_ == nullptr) return is_held;
    const auto before = [](const FlatEdge& edge, std::pair<Index, Index> ends) {
      return std::pair(edge.from, edge.to) < ends;
    };
    for (std::size_t k = 0; k < disk_.border.size(); ++k) {
      if (border_->lengths.may_change(k)) continue;
      const std::pair<Index, Index> ends =
          std::minmax(disk_.border[k], disk_.border[disk_.loops.next(k)]);
      const auto found = std::lower_bound(edges_.begin(), edges_.end(), ends, before);
      is_held[static_cast<std::size_t>(found - edges_.begin())] = 1;
    }
    return is_held;
  }

  double weighed_p99(const std::vector<Vec2>& flat, const EdgeBounds& limit) const {
    return strain_at_share(with_areas(edges_, all_weighed(strains_of(edges_, flat), limit)),
                           k_asked);
  }

  /// @param most that freed edges may have
  std::vector<EdgeBounds> with_worst_freed(const EdgeBounds& limit,
                                           const std::vector<double>& strains,
                                           const EdgeBounds& most) const {
    std::vector<std::size_t> order(edges_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return weighed(strains[a], limit) > weighed(strains[b], limit);
    });
    std::vector<EdgeBounds> bounds(edges_.size(), limit);
    double freed = 0.0;
    for (const std::size_t e : order) {
      if (is_held_[e] != 0) continue;
      freed += edges_[e].area;
      if (freed > k_freed) break;
      bounds[e] = most;
    }
    return bounds;
  }

  const Disk& disk_;
  const HeldBorder* border_;
  std::vector<FlatEdge> edges_;
  std::vector<char> is_held_;  // of each edge: it keeps its length
  int max_iterations_;
  ThreadPool& pool_;
  const std::function<void()>& after_step_;
  int iterations_;
};

}  // namespace

LeastStretch unfold_within_limits(const TriMesh& mesh, const Disk& disk, const HeldBorder* border,
                                  const LeastStretch& least, const StrainLimits& limits,
                                  int max_iterations, ThreadPool& pool,
                                  const std::function<void()>& after_step) {
  LimitedUnfolding unfolding(mesh, disk, border, max_iterations, pool, after_step,
                             least.iterations);
  StrainLimits of_edges = limits;
  of_edges.rms = 0.0;
  const auto strain_of = [&](const std::vector<Vec2>& flat) {
    return figures_of(with_areas(unfolding.edges(), strains_of(unfolding.edges(), flat)));
  };
  const EdgeStrain strain = strain_of(least.flat);
  if (of_edges.kept_by(strain)) return least;
  const LimitsOfEdges bounds(limits);
  BoundedStretch found = bounds.differ() ? unfolding.keep_on_99_percent(bounds, least.flat)
                                         : unfolding.keep(bounds.all, least.flat);
  // A run that ended at max_iterations may have reached less than it began with.
  if (!(largest_share(limits, strain_of(found.flat)) < largest_share(limits, strain))) return least;
  return {std::move(found.flat), unfolding.iterations(), found.converged};
}

double smallest_limit_of(const TriMesh& mesh, const Disk& disk, std::vector<Vec2> least,
                         int max_iterations, ThreadPool& pool,
                         const std::function<void()>& after_step) {
  constexpr double weight = 300.0;
  LimitedUnfolding unfolding(mesh, disk, nullptr, max_iterations, pool, after_step, 0);
  const double largest_now = largest(strains_of(unfolding.edges(), least));
  if (!(largest_now > k_no_strain)) return largest_now;
  const std::vector<EdgeBounds> bounds(unfolding.edges().size(), {largest_now, largest_now});
  const BoundedStretch found =
      unfolding.run(bounds, std::move(least), {.least_scale = 0.0, .weight = weight});
  return std::min(largest_now, largest(strains_of(unfolding.edges(), found.flat)));
}

}  // namespace planish
