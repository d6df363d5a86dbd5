#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include <planish/measure/cautions.h>
#include <planish/measure/fairness.h>

#include "core/neumaier_sum.h"
#include "measure/area.h"
#include "measure/bends.h"
#include "measure/cautions/straight_rows.h"
#include "measure/cautions/triangle_hinges.h"
#include "measure/off_border.h"
#include "measure/smoothed.h"

namespace planish {

namespace {

// A vertex whose edges bend less than this, radians, makes no surface rough.
constexpr double k_seen_bend = 0.05;
// A dome or a crease bends all edges of a vertex, or two of them, one way; this share is mixed.
constexpr double k_one_way = 0.2;
constexpr double k_like = 0.4;                 // a neighbour is bent alike from this share on
constexpr double k_smooth = 0.35;              // the mean of the neighbours, of its own
constexpr double k_regular = 0.65;             // a texture repeats itself as well as this
constexpr double k_noisy_share = 0.25;         // of the area
constexpr std::size_t k_fewest_vertices = 30;  // of fewer, nothing can be said

/// Whether two neighbours on opposite sides are bent as the vertex is: along a crease or a ruling,
/// or on a dome, there are always such two.
bool is_on_line(const Patch& patch, const std::vector<double>& curvatures, Index v) {
  const auto ring = patch.ring(v);
  const std::size_t n = ring.size();
  const double own = curvatures[v];
  const auto is_like = [&](std::size_t j) {
    return curvatures[ring[j % n]] * own > 0.0 &&
           std::abs(curvatures[ring[j % n]]) >= k_like * std::abs(own);
  };
  for (std::size_t j = 0; j < n; ++j) {
    if (is_like(j) && (is_like(j + n / 2) || is_like(j + (n + 1) / 2))) return true;
  }
  return false;
}

/// Whether those around a vertex are bent as it is, on the average: those of a smooth form of five
/// edges or more to a wave are, those of noise in the other sense.
bool is_smooth(const Patch& patch, const std::vector<double>& curvatures, Index v) {
  double sum = 0.0;
  for (const Index other : patch.ring(v))
    sum += curvatures[other];
  const double own = curvatures[v];
  return sum * own > k_smooth * own * own * static_cast<double>(patch.ring(v).size());
}

/// Calls visit(values) for the values of inner vertices along each straight row of edges that
/// begins and ends, in both directions.
template <class Visit>
void for_each_row(const Patch& patch, const std::vector<double>& values, const Visit& visit) {
  std::vector<double> row;
  for (const Index first : patch.inner_vertices()) {
    for (const Index second : patch.ring(first)) {
      const Index before = straight_on(patch, second, first);
      if (before != Edge::none && !patch.is_border(before)) continue;
      row.clear();
      Index from = first, to = second;
      row.push_back(values[from]);
      while (to != Edge::none && !patch.is_border(to)) {
        row.push_back(values[to]);
        const Index next = straight_on(patch, from, to);
        from = to;
        to = next;
      }
      visit(row);
    }
  }
}

/// How well rows of curvatures repeat themselves: their correlation with themselves at the best
/// distance, from 0 to 1. Noise repeats itself by chance only.
double repetition(const Patch& patch, const std::vector<double>& curvatures) {
  constexpr std::size_t k_nearest = 3, k_farthest = 16;
  NeumaierSum repeated, all;
  for_each_row(patch, curvatures, [&](const std::vector<double>& row) {
    const std::size_t n = row.size();
    if (n < 4 * k_nearest) return;
    double mean = 0.0;
    for (const double value : row)
      mean += value / static_cast<double>(n);
    double variance = 0.0, best = 0.0;
    for (const double value : row)
      variance += (value - mean) * (value - mean) / static_cast<double>(n);
    for (std::size_t lag = k_nearest; lag <= std::min(n / 2, k_farthest); ++lag) {
      double sum = 0.0;
      for (std::size_t i = lag; i < n; ++i)
        sum += (row[i] - mean) * (row[i - lag] - mean);
      best = std::max(best, sum / static_cast<double>(n - lag));
    }
    repeated.add(static_cast<double>(n) * best);
    all.add(static_cast<double>(n) * variance);
  });
  return all.value() > 0.0 ? repeated.value() / all.value() : 0.0;
}

/// The share of the area that bends, but along no line, of all area whose vertices have no
/// neighbour on the border.
double noisy_share(const Patch& patch) {
  const std::vector<double> curvatures = vertex_mean_curvatures(patch), bends = vertex_bends(patch),
                            areas = triangle_areas(patch);
  std::vector<double> around(patch.vertex_count(), 0.0);
  for (Index t = 0; t < areas.size(); ++t) {
    for (const Index v : patch.triangles()[t])
      around[v] += areas[t] / 3.0;
  }
  const double edge = mean_side_of(patch.mesh(), patch.unit_scale()) / patch.unit_scale();
  NeumaierSum noisy, all;
  std::size_t count = 0;
  for (const Index v : patch.inner_vertices()) {
    if (!is_off_border(patch.connectivity(), v)) continue;
    ++count;
    all.add(around[v]);
    if (bends[v] * edge < k_seen_bend || std::abs(curvatures[v]) < k_one_way * bends[v]) continue;
    if (!is_on_line(patch, curvatures, v) && !is_smooth(patch, curvatures, v)) noisy.add(around[v]);
  }
  if (count < k_fewest_vertices || !(all.value() > 0.0)) return 0.0;
  const double share = noisy.value() / all.value();
  return share >= k_noisy_share && repetition(patch, curvatures) > k_regular ? 0.0 : share;
}

/// How much the surface turns off its border: a crease that is rounded turns as much as before.
double turning_inside(const Patch& patch, const std::vector<Vec3>& positions) {
  NeumaierSum turning;
  for_each_bend(positions, patch.connectivity(), patch.unit_scale(),
                [&](const Hinge& hinge, const Bend& bend) {
                  if (is_off_border(patch.connectivity(), hinge.from) &&
                      is_off_border(patch.connectivity(), hinge.to))
                    turning.add(std::abs(bend.angle) * bend.length);
                });
  return turning.value();
}

/// How far inner vertices are from where they were, rms; model units.
double usual_move(const Patch& patch, const std::vector<Vec3>& after) {
  const double scale = patch.unit_scale();
  NeumaierSum squares;
  for (const Index v : patch.inner_vertices()) {
    const Vec3 move = scale * after[v] - scale * patch.positions()[v];
    squares.add(dot(move, move));
  }
  return std::sqrt(squares.value() / static_cast<double>(patch.inner_vertices().size())) / scale;
}

}  // namespace

std::optional<ScanNoise> find_scan_noise(const Patch& patch) {
  if (!(noisy_share(patch) >= k_noisy_share)) return std::nullopt;
  // Waves are form from where taking out longer ones hardly makes it turn less.
  constexpr std::array waves = {3.0, 4.0, 6.0, 9.0, 13.0};  // mean edges
  constexpr double hardly = 0.82;
  const double edge = mean_side_of(patch.mesh(), patch.unit_scale()) / patch.unit_scale();
  ScanNoise noise;
  double turning = std::numeric_limits<double>::infinity();
  for (const double wave : waves) {
    const std::vector<Vec3> smooth = smoothed_positions(patch, wave * edge);
    const double left = turning_inside(patch, smooth);
    if (left > hardly * turning) break;
    turning = left;
    noise = {usual_move(patch, smooth), wave * edge};
  }
  return noise;
}

}  // namespace planish
