#include "measure/form/form_change.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <queue>
#include <utility>

#include "core/neumaier_sum.h"
#include "measure/area.h"
#include "measure/form/compared.h"
#include "measure/smoothed.h"

namespace planish {

namespace {

// Radii of windows, of the size. What is seen as an edge; as rough; as a feature; as a hill; as a
// dent.
constexpr double k_edge_radius = 0.02, k_bend_radius = 0.025, k_feature_radius = 0.06,
                 k_relief_radius = 0.12, k_dent_radius = 0.1;
constexpr double k_least_feature_edges = 2.0;

// Added bending is compared with the design's bending in the window, plus the bending that two
// thirds of its area stay below, plus a constant (over the square of the size). The second keeps
// one sharp bead from masking waves beside it; bending below the constant cannot be seen.
constexpr double k_calm_part = 2.0 / 3.0, k_least_bending = 8.0;

// Added bending counts by this factor where the window is nearer to the border than this many
// radii: people notice it less there.
constexpr double k_border_radii = 1.15, k_border_part = 0.6;

// Mean edges, of each surface its own: noise is nearly all in shorter waves.
constexpr double k_noise_wave = 4.0;

constexpr double k_least_relief = 0.05;  // rms height over the radius, from which it stands out
constexpr double k_least_edge = 0.15;    // rms turn across an edge, radians
// Of all edges, and of the area: less is not missed, and noise has as much.
constexpr double k_least_edge_part = 0.3, k_least_edge_area = 0.01;

/// Figures of windows, each with its part of the area.
class Figures {
 public:
  void add(double value, double share, Index middle) {
    if (value > largest_) {
      largest_ = value;
      at_ = middle;
    }
    values_.emplace_back(value, values_.size());
    shares_.push_back(share);
  }
  double area() const {
    NeumaierSum area;
    for (const double share : shares_)
      area.add(share);
    return area.value();
  }
  /// What so large a part of the area has at most; 0 without windows.
  double at_most_on(double part) const {
    auto order = values_;
    std::sort(order.begin(), order.end());
    const double needed = part * area();
    NeumaierSum so_far;
    for (const auto& [value, i] : order) {
      so_far.add(shares_[i]);
      if (so_far.value() >= needed) return value;
    }
    return 0.0;
  }
  double largest() const { return largest_; }
  Index place_of_largest() const { return at_; }

 private:
  std::vector<std::pair<double, std::size_t>> values_;
  std::vector<double> shares_;
  double largest_ = 0.0;
  Index at_ = 0;
};

/// How far each vertex of the design is from the border, along edges; infinity beyond `most`.
std::vector<double> border_distances(const Compared& pair, double most) {
  using Entry = std::pair<double, Index>;
  std::vector<double> distances(pair.before.size(), std::numeric_limits<double>::infinity());
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  const auto reach = [&](Index v, double distance) {
    if (!(distance < distances[v]) || distance > most) return;
    distances[v] = distance;
    queue.emplace(distance, v);
  };
  for (Index v = 0; v < pair.before.size(); ++v)
    if (pair.connectivity.is_border(v)) reach(v, 0.0);
  while (!queue.empty()) {
    const auto [distance, v] = queue.top();
    queue.pop();
    if (distance > distances[v]) continue;
    for (const Index w : pair.connectivity.ring(v))
      reach(w, distance + norm(pair.before[w] - pair.before[v]));
  }
  return distances;
}

/// The bending of a window, and its part of the area.
struct WindowBending {
  double before = 0.0, after = 0.0, area = 0.0;
  double share = 0.0;
  Index middle = 0;

  /// Root of the bending that came over that which the design has, and `calm` over the area.
  double more(double calm) const {
    const double beside = before + area * (calm + k_least_bending);
    return after > before && beside > 0.0 ? std::sqrt((after - before) / beside) : 0.0;
  }
};

WindowBending bending_of(const Compared& pair, const Window& window) {
  WindowBending bending{.share = window.share, .middle = window.vertices.front()};
  for (std::size_t i = 0; i < window.vertices.size(); ++i) {
    const Index v = window.vertices[i];
    bending.before += window.weights[i] * pair.bending_before[v];
    bending.after += window.weights[i] * pair.bending_after[v];
    bending.area += window.weights[i] * pair.areas[v];
  }
  return bending;
}

/// How much more the result is bent.
struct MoreBent {
  double nearly_all = 0.0, largest = 0.0;
  Index at = 0;
};

MoreBent more_bent(const Compared& pair) {
  constexpr double nearly_all = 0.99;
  std::vector<WindowBending> windows;
  Figures designed, bent;
  const double radius = pair.radius(k_bend_radius);
  const double near_border = k_border_radii * radius;
  const std::vector<double> to_border = border_distances(pair, near_border);
  pair.for_windows(radius, [&](const Window& window) {
    const WindowBending found = bending_of(pair, window);
    if (!(found.area > 0.0)) return;
    designed.add(found.before / found.area, found.share, found.middle);
    windows.push_back(found);
  });
  const double calm = designed.at_most_on(k_calm_part);
  for (const WindowBending& window : windows) {
    const double part = to_border[window.middle] > near_border ? 1.0 : k_border_part;
    bent.add(part * window.more(calm), window.share, window.middle);
  }
  return {bent.at_most_on(nearly_all), bent.largest(), bent.place_of_largest()};
}

/// A design without the shortest waves, which are most of what noise is bent, and a result without
/// them: what the noise has of longer waves hides none that are higher.
struct BelowNoise {
  Patch design;
  Compared pair;

  BelowNoise(const Patch& noisy, std::span<const Vec3> after)
      : design(noisy.with_positions(smooth(noisy, noisy.positions()))),
        pair(compared(design, smooth(noisy, {after.begin(), after.end()}), size_of(design))) {}

 private:
  static std::vector<Vec3> smooth(const Patch& noisy, std::vector<Vec3> positions) {
    const Patch patch = noisy.with_positions(std::move(positions));
    const double scale = patch.unit_scale();
    return smoothed_positions(patch, k_noise_wave * mean_side_of(patch.mesh(), scale) / scale);
  }
};

void find_folds(const Compared& pair, std::span<const Vec3> after,
                const std::optional<BelowNoise>& below_noise, FormChange& change) {
  const MoreBent bent = more_bent(pair), below = below_noise ? more_bent(below_noise->pair) : bent;
  change.ripple = std::max(bent.nearly_all, below.nearly_all);
  change.fold = std::max(bent.largest, below.largest);
  change.fold_at = after[below.largest > bent.largest ? below.at : bent.at];
}

void find_lost_edges(const Compared& pair, FormChange& change) {
  Figures lost;
  double all = 0.0;
  const double radius = pair.radius(k_edge_radius);
  pair.for_windows(radius, [&](const Window& window) {
    all += window.share;
    const double turn = turn_across(pair, window, pair.normals_before);
    if (turn <= k_least_edge) return;
    const double kept = turn_across(pair, window, pair.normals_after) / turn;
    lost.add(1.0 - kept, window.share, window.vertices.front());
  });
  const double edges = lost.area(),
               least = std::max(k_least_edge_part * edges, k_least_edge_area * all);
  if (edges > least) change.edge_lost = std::max(lost.at_most_on(1.0 - least / edges), 0.0);
}

void find_lost_relief(const Compared& pair, FormChange& change) {
  constexpr double less_than_half = 0.4;  // the rest lost as much or more
  Figures lost;
  const double radius = pair.radius(k_relief_radius);
  pair.for_windows(radius, [&](const Window& window) {
    const Relief relief = relief_of(pair, window);
    if (relief.rms > k_least_relief * radius)
      lost.add(1.0 - relief.kept, window.share, window.vertices.front());
  });
  change.relief_lost = std::max(lost.at_most_on(less_than_half), 0.0);
}

void find_uneven_turns(const Compared& pair, FormChange& change) {
  constexpr double nearly_all = 0.98;
  Figures turns;
  const double radius = pair.radius(k_feature_radius, k_least_feature_edges);
  pair.for_windows(radius, [&](const Window& window) {
    turns.add(uneven_turn_of(pair, window, radius), window.share, window.vertices.front());
  });
  change.uneven_turn = turns.at_most_on(nearly_all);
}

void find_dents(const Compared& pair, std::span<const Vec3> after, FormChange& change) {
  constexpr double nearly_all = 0.98;
  Figures dents;
  const double radius = pair.radius(k_dent_radius);
  pair.for_windows(radius, [&](const Window& window) {
    dents.add(dent_of(pair, window, radius) / radius, window.share, window.vertices.front());
  });
  change.dent = dents.at_most_on(nearly_all);
  change.dent_at = after[dents.place_of_largest()];
}

}  // namespace

bool FormChange::is_rippled() const {
  return ripple > k_seen_ripple;
}

bool FormChange::is_folded() const {
  return fold > k_seen_new_fold;
}

bool FormChange::is_dented() const {
  return dent > k_seen_dent;
}

bool FormChange::is_uneven() const {
  return uneven_turn > k_seen_uneven_turn;
}

bool FormChange::has_lost_relief() const {
  return relief_lost > k_seen_relief_lost;
}

bool FormChange::has_lost_edge() const {
  return edge_lost > k_seen_edge_lost;
}

FormChange form_change_of(const Patch& design, std::span<const Vec3> after, bool is_noisy) {
  FormChange change;
  const double size = size_of(design);
  if (!(size > 0.0)) return change;
  const Compared pair = compared(design, after, size);
  std::optional<BelowNoise> below_noise;
  if (is_noisy) below_noise.emplace(design, after);
  find_folds(pair, after, below_noise, change);
  find_lost_edges(pair, change);
  // Noise that went is no feature and no hill.
  const Compared& shown = below_noise ? below_noise->pair : pair;
  find_uneven_turns(shown, change);
  find_lost_relief(shown, change);
  find_dents(pair, after, change);
  return change;
}

}  // namespace planish
