#include "evolve/auto/shared/defect_clusters.h"

#include <algorithm>
#include <numbers>
#include <utility>

#include <planish/measure/flattenability.h>

#include "core/math.h"
#include "evolve/auto/shared/tuning.h"
#include "evolve/systems/dual_system.h"
#include "evolve/systems/positions.h"
#include "geometry/smallest_angle.h"

namespace planish {

using namespace tuning::polish;

namespace {

/// Largest first, until they have nearly all of the energy. Defects are left out that are as small
/// as the mean of a flattenable patch.
std::vector<Index> vertices_of_largest_defects(const PatchState& state) {
  const auto square = [&](Index v) { return state.defect(v) * state.defect(v); };
  std::vector<Index> vertices(state.inner_count());
  double energy = 0.0;
  for (Index v = 0; v < vertices.size(); ++v) {
    vertices[v] = v;
    energy += square(v);
  }
  const auto is_larger = [&](Index v, Index w) {
    return square(v) != square(w) ? square(v) > square(w) : v < w;
  };
  const auto last =
      vertices.begin() + std::min<std::ptrdiff_t>(k_most_largest, std::ssize(vertices));
  std::partial_sort(vertices.begin(), last, vertices.end(), is_larger);
  const double small =
      k_defect_sum_share * k_flattenable_sum / std::max(1.0, static_cast<double>(vertices.size()));
  double covered = 0.0;
  const auto end = std::find_if(vertices.begin(), last, [&](Index v) {
    const bool enough = covered >= k_share_of_largest * energy || square(v) <= small * small;
    covered += square(v);
    return enough;
  });
  vertices.erase(end, vertices.end());
  return vertices;
}

/// The inner vertices up to this number of edges away, increasing.
std::vector<Index> inner_vertices_around(std::vector<Index> vertices, int edges,
                                         const AngleJacobian& jacobian) {
  std::vector<unsigned char> seen(jacobian.row_count(), 0);
  for (const Index v : vertices)
    seen[v] = 1;
  std::size_t begin = 0;
  for (int i = 0; i < edges; ++i) {
    for (const std::size_t end = vertices.size(); begin < end; ++begin) {
      for (const Index w : jacobian.ring(vertices[begin])) {
        if (w >= seen.size() || seen[w] != 0) continue;
        seen[w] = 1;
        vertices.push_back(w);
      }
    }
  }
  std::sort(vertices.begin(), vertices.end());
  return vertices;
}

/// What a cluster has come to.
struct Progress {
  double energy = 0.0;
  double damping = k_first_cluster_damping;  // over the median of the diagonal
  bool over = false;
};

class ClusterSteps {
 public:
  ClusterSteps(PatchState& state, const AngleJacobian& whole, DefectClusters clusters,
               std::span<const double> inverse_weights, const DescentLimits& limits,
               ThreadPool& pool)
      : state_(state),
        pool_(pool),
        clusters_(std::move(clusters)),
        inverse_weights_(inverse_weights),
        limits_(limits),
        whole_(whole),
        jacobian_(whole.part(clusters_.rows, movable())),
        dual_(jacobian_, state),
        defects_(static_cast<Eigen::Index>(clusters_.rows.size())),
        progress_(clusters_.count) {
    const std::vector<double> energies = measure();
    for (std::size_t c = 0; c < energies.size(); ++c)
      progress_[c].energy = energies[c];
  }

  /// One step of each cluster that is not over. @return false where all are
  bool step() {
    if (std::all_of(progress_.begin(), progress_.end(), [](const Progress& p) { return p.over; }))
      return false;
    jacobian_.update(state_.positions(), pool_);
    measure();
    if (!dual_.factor_with(inverse_weights_, damping(), pool_)) return false;
    const Positions moves = jacobian_.transposed_times(dual_.solve(defects_, pool_), pool_);
    std::vector<Vec3> before;
    for (std::size_t i = 0; i < clusters_.vertices.size(); ++i) {
      const Index v = clusters_.vertices[i];
      before.push_back(state_.position(v));
      if (progress_[clusters_.cluster_of_vertex[i]].over) continue;
      state_.move(v, before.back() + inverse_weights_[v] * moves[v]);
    }
    judge(before);
    return true;
  }

 private:
  std::vector<unsigned char> movable() const {
    std::vector<unsigned char> movable(state_.inner_count(), 0);
    for (const Index v : clusters_.vertices)
      movable[v] = 1;
    return movable;
  }

  /// Takes the defects of all rows. @return the energy of each cluster
  std::vector<double> measure() {
    pool_.for_ranges(clusters_.rows.size(), 512, [this](std::size_t begin, std::size_t end) {
      for (std::size_t row = begin; row < end; ++row)
        defects_[static_cast<Eigen::Index>(row)] =
            2.0 * std::numbers::pi - whole_.angle_sum(clusters_.rows[row], state_.positions());
    });
    std::vector<double> energies(clusters_.count, 0.0);
    for (std::size_t row = 0; row < clusters_.rows.size(); ++row) {
      const double d = defects_[static_cast<Eigen::Index>(row)];
      energies[clusters_.cluster_of_row[row]] += d * d;
    }
    return energies;
  }

  /// By row, over the median of the diagonal of each cluster.
  std::vector<double> damping() {
    std::vector<double> diagonal(clusters_.rows.size(), 0.0);
    for (const Index v : clusters_.vertices) {
      for (const auto& entry : jacobian_.column(v)) {
        const Vec3 g = jacobian_.gradient(entry.entry);
        diagonal[entry.row] += inverse_weights_[v] * dot(g, g);
      }
    }
    std::vector<std::vector<double>> of_cluster(clusters_.count);
    for (std::size_t row = 0; row < diagonal.size(); ++row)
      of_cluster[clusters_.cluster_of_row[row]].push_back(diagonal[row]);
    for (std::size_t c = 0; c < clusters_.count; ++c) {
      std::vector<double>& values = of_cluster[c];
      const auto middle = values.begin() + std::ssize(values) / 2;
      std::nth_element(values.begin(), middle, values.end());
      values = {*middle > 0.0 ? progress_[c].damping * *middle : 1.0};
    }
    for (std::size_t row = 0; row < diagonal.size(); ++row)
      diagonal[row] = of_cluster[clusters_.cluster_of_row[row]].front();
    return diagonal;
  }

  /// Keeps the moves of the clusters whose energy fell within the limits and takes the others back.
  void judge(const std::vector<Vec3>& before) {
    const std::vector<double> energies = measure();
    const std::vector<unsigned char> sound = within_limits();
    std::vector<unsigned char> taken(clusters_.count, 0);
    for (std::size_t c = 0; c < clusters_.count; ++c) {
      Progress& cluster = progress_[c];
      if (cluster.over) continue;
      if (energies[c] < cluster.energy && sound[c] != 0) {
        taken[c] = 1;
        cluster.over = energies[c] > k_little_fall * cluster.energy &&
                       cluster.damping <= k_least_cluster_damping;
        cluster.energy = energies[c];
        cluster.damping = std::max(k_damping.ease * cluster.damping, k_least_cluster_damping);
      } else {
        cluster.damping *= k_tighten_much;
        cluster.over = !(cluster.damping <= k_most_cluster_damping);
      }
    }
    for (std::size_t i = 0; i < clusters_.vertices.size(); ++i) {
      if (taken[clusters_.cluster_of_vertex[i]] == 0) state_.move(clusters_.vertices[i], before[i]);
    }
  }

  /// By cluster.
  std::vector<unsigned char> within_limits() const {
    std::vector<unsigned char> sound(clusters_.count, 1);
    const double cosine = math::cos(limits_.angle);
    for (std::size_t i = 0; i < clusters_.vertices.size(); ++i) {
      const Index v = clusters_.vertices[i];
      const Vec3 p = state_.position(v);
      bool keeps = norm(p - state_.origin(v)) <= limits_.deviation;
      const auto ring = whole_.ring(v);
      for (std::size_t j = 0; keeps && j < ring.size(); ++j)
        keeps = has_smallest_angle_from(limits_.angle, cosine, p, state_.position(ring[j]),
                                        state_.position(ring[(j + 1) % ring.size()]));
      if (!keeps) sound[clusters_.cluster_of_vertex[i]] = 0;
    }
    return sound;
  }

  PatchState& state_;
  ThreadPool& pool_;
  DefectClusters clusters_;
  std::span<const double> inverse_weights_;
  DescentLimits limits_;
  const AngleJacobian& whole_;
  AngleJacobian jacobian_;
  DualSystem dual_;
  Eigen::VectorXd defects_;  // by row
  std::vector<Progress> progress_;
};

/// Finds which vertices and rows are in one cluster.
class ClusterSearch {
 public:
  ClusterSearch(const AngleJacobian& jacobian, DefectClusters& clusters)
      : jacobian_(jacobian), clusters_(clusters) {}

  void run() {
    clusters_.cluster_of_vertex.assign(clusters_.vertices.size(), k_no_cluster);
    clusters_.cluster_of_row.assign(clusters_.rows.size(), k_no_cluster);
    for (const Index v : clusters_.vertices) {
      if (!enter_vertex(v)) continue;
      enter_rows();
      ++clusters_.count;
    }
  }

 private:
  static constexpr Index k_no_cluster = static_cast<Index>(-1);

  /// Into the cluster of this number. @return false where it is not in the list or was there before
  bool enter(Index v, const std::vector<Index>& list, std::vector<Index>& cluster_of) const {
    const auto at = std::lower_bound(list.begin(), list.end(), v);
    if (at == list.end() || *at != v) return false;
    Index& cluster = cluster_of[static_cast<std::size_t>(at - list.begin())];
    if (cluster != k_no_cluster) return false;
    cluster = static_cast<Index>(clusters_.count);
    return true;
  }

  bool enter_vertex(Index v) {
    if (!enter(v, clusters_.vertices, clusters_.cluster_of_vertex)) return false;
    enter_row(v);
    for (const Index w : jacobian_.ring(v))
      enter_row(w);
    return true;
  }

  void enter_row(Index v) {
    if (enter(v, clusters_.rows, clusters_.cluster_of_row)) open_.push_back(v);
  }

  /// The vertices of each row that was entered, and their rows.
  void enter_rows() {
    while (!open_.empty()) {
      const Index row = open_.back();
      open_.pop_back();
      enter_vertex(row);
      for (const Index w : jacobian_.ring(row))
        enter_vertex(w);
    }
  }

  const AngleJacobian& jacobian_;
  DefectClusters& clusters_;
  std::vector<Index> open_;  // rows that were entered
};

}  // namespace

DefectClusters clusters_of_largest_defects(const PatchState& state, const AngleJacobian& jacobian) {
  DefectClusters clusters;
  for (const Index v :
       inner_vertices_around(vertices_of_largest_defects(state), k_cluster_edges, jacobian)) {
    if (jacobian.is_movable(v)) clusters.vertices.push_back(v);
  }
  clusters.rows = inner_vertices_around(clusters.vertices, 1, jacobian);
  ClusterSearch(jacobian, clusters).run();
  return clusters;
}

void reduce_largest_defects(PatchState& state, const AngleJacobian& jacobian,
                            std::span<const double> inverse_weights, const DescentLimits& limits,
                            ThreadPool& pool) {
  DefectClusters clusters = clusters_of_largest_defects(state, jacobian);
  if (clusters.count == 0) return;
  ClusterSteps steps(state, jacobian, std::move(clusters), inverse_weights, limits, pool);
  for (int i = 0; i < k_most_cluster_steps && steps.step(); ++i) {
  }
}

}  // namespace planish
