#include "measure/smoothed.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>
#include <utility>

#include <planish/core/range.h>
#include <planish/measure/fairness.h>

#include "core/neumaier_sum.h"

namespace planish {

namespace {

// For a wave of two edges, where triangles are of one size, the matrix has the condition 4, and a
// dozen steps do; needles take some more. The root of the condition grows with the wave squared.
constexpr double k_most_steps = 60.0, k_usual_wave = 2.0;
constexpr double k_enough = 1e-10;  // of the squared residual
constexpr int k_held = -1;

using Columns = std::vector<Vec3>;  // a place or a move of each inner vertex

/// Cotangents of a triangle's angles. Where it has hardly any area all three are divided by the
/// same, which leaves the Laplacian without negative eigenvalues.
std::array<double, 3> cotangents(const std::array<Vec3, 3>& p) {
  constexpr double least = 1e-6;
  std::array<double, 3> values{};
  double longest = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 a = p[(k + 1) % 3] - p[k], b = p[(k + 2) % 3] - p[k];
    values[k] = dot(a, b);
    longest = std::max(longest, dot(a, a));
  }
  const double doubled = std::max(norm(cross(p[1] - p[0], p[2] - p[0])), least * longest);
  for (double& value : values)
    value = doubled > 0.0 ? value / doubled : 0.0;
  return values;
}

/// The inner vertices' rows of the Laplacian, and their masses.
struct InnerRows {
  explicit InnerRows(const Connectivity& of_patch)
      : connectivity(of_patch), number(of_patch.vertex_count(), k_held) {
    int count = 0;
    for (const Index v : connectivity.inner_vertices())
      number[v] = count++;
  }
  int size() const { return static_cast<int>(masses.size()); }

  std::span<const Index> ring(std::size_t row) const {
    return connectivity.ring(connectivity.inner_vertices()[row]);
  }

  const Connectivity& connectivity;
  std::vector<int> number;      // of each vertex among the inner ones
  std::vector<double> weights;  // of the edges, row by row; the diagonal is their sum
  std::vector<double> masses;
  Columns pull;  // L x0
};

/// Appends the row of one vertex at p.
void append_row(Vec3 p, const std::vector<Vec3>& ring, InnerRows& rows) {
  const std::size_t n = ring.size(), first = rows.weights.size();
  rows.weights.resize(first + n, 0.0);
  double area = 0.0;
  for (std::size_t j = 0; j < n; ++j) {
    const std::size_t next = j + 1 < n ? j + 1 : 0;
    const auto values = cotangents({p, ring[j], ring[next]});
    rows.weights[first + next] += 0.5 * values[1];
    rows.weights[first + j] += 0.5 * values[2];
    area += 0.5 * norm(cross(ring[j] - p, ring[next] - p));
  }
  Vec3 pull;
  for (std::size_t j = 0; j < n; ++j)
    pull += rows.weights[first + j] * (p - ring[j]);
  rows.pull.push_back(pull);
  rows.masses.push_back(area / 3.0);
}

/// @param positions of all vertices
InnerRows rows_of(const Columns& positions, const Connectivity& connectivity) {
  InnerRows rows(connectivity);
  std::size_t entries = 0;
  for (const Index v : connectivity.inner_vertices())
    entries += connectivity.ring(v).size();
  rows.weights.reserve(entries);
  rows.masses.reserve(connectivity.inner_vertices().size());
  rows.pull.reserve(connectivity.inner_vertices().size());
  std::vector<Vec3> ring;
  for (const Index v : connectivity.inner_vertices()) {
    ring.clear();
    for (const Index w : connectivity.ring(v))
      ring.push_back(positions[w]);
    append_row(positions[v], ring, rows);
  }
  // A vertex without area would be divided by.
  NeumaierSum sum;
  for (const double mass : rows.masses)
    sum.add(mass);
  const double least = 1e-9 * sum.value() / std::max(1, rows.size());
  for (double& mass : rows.masses)
    mass = std::max(mass, least);
  return rows;
}

/// L x.
Columns laplacian_of(const Columns& x, const InnerRows& rows) {
  Columns result(x.size());
  const double* weight = rows.weights.data();
  for (std::size_t v = 0; v < x.size(); ++v) {
    Vec3 sum;
    for (const Index w : rows.ring(v)) {
      const int column = rows.number[w];
      sum += *weight++ * (column == k_held ? x[v] : x[v] - x[static_cast<Index>(column)]);
    }
    result[v] = sum;
  }
  return result;
}

/// Of each of the three coordinates.
/// @param b its entries by number
template <class F>
Vec3 products(const Columns& a, F b) {
  NeumaierSum x, y, z;
  for (std::size_t v = 0; v < a.size(); ++v) {
    const Vec3 other = b(v);
    x.add(a[v].x * other.x);
    y.add(a[v].y * other.y);
    z.add(a[v].z * other.z);
  }
  return {x.value(), y.value(), z.value()};
}

Vec3 by_coordinate(Vec3 a, Vec3 b) {
  return {a.x * b.x, a.y * b.y, a.z * b.z};
}

Vec3 ratios(Vec3 a, Vec3 b) {
  const auto ratio = [](double p, double q) { return q > 0.0 ? p / q : 0.0; };
  return {ratio(a.x, b.x), ratio(a.y, b.y), ratio(a.z, b.z)};
}

/// The diagonal of M + t L M^-1 L.
std::vector<double> diagonal_of(const InnerRows& rows, double t) {
  std::vector<double> diagonal = rows.masses;
  const double* next = rows.weights.data();
  for (std::size_t v = 0; v < diagonal.size(); ++v) {
    double sum = 0.0;
    for (const Index w : rows.ring(v)) {
      const double weight = *next++;
      const int column = rows.number[w];
      sum += weight;
      if (column != k_held)
        diagonal[v] += t * weight * weight / rows.masses[static_cast<Index>(column)];
    }
    diagonal[v] += t * sum * sum / rows.masses[v];
  }
  return diagonal;
}

/// (M + t L M^-1 L) x.
Columns smoothing_of(const Columns& x, const InnerRows& rows, double t) {
  Columns once = laplacian_of(x, rows);
  for (std::size_t v = 0; v < once.size(); ++v)
    once[v] = (1.0 / rows.masses[v]) * once[v];
  Columns result = laplacian_of(once, rows);
  for (std::size_t v = 0; v < x.size(); ++v)
    result[v] = rows.masses[v] * x[v] + t * result[v];
  return result;
}

double sum_of(Vec3 a) {
  return a.x + a.y + a.z;
}

/// d with A (x0 + d) = M x0 on inner vertices, so A d = -t L M^-1 (L x0): conjugate gradients,
/// preconditioned by the diagonal.
Columns moves_of(InnerRows rows, double t, int most_steps) {
  Columns residual = std::move(rows.pull);
  for (std::size_t v = 0; v < residual.size(); ++v)
    residual[v] = (-t / rows.masses[v]) * residual[v];
  residual = laplacian_of(residual, rows);
  const std::vector<double> diagonal = diagonal_of(rows, t);
  Columns moves(residual.size()), direction(residual.size());
  const auto better = [&](std::size_t v) { return (1.0 / diagonal[v]) * residual[v]; };
  Vec3 before{};
  double first = 0.0;
  for (int k = 0; k < most_steps; ++k) {
    const Vec3 now = products(residual, better), keep = ratios(now, before);
    if (k == 0) first = sum_of(now);
    if (!(sum_of(now) > k_enough * first)) break;
    for (std::size_t v = 0; v < moves.size(); ++v)
      direction[v] = better(v) + by_coordinate(keep, direction[v]);
    const Columns change = smoothing_of(direction, rows, t);
    const Vec3 step = ratios(now, products(direction, [&](std::size_t v) { return change[v]; }));
    for (std::size_t v = 0; v < moves.size(); ++v) {
      moves[v] += by_coordinate(step, direction[v]);
      residual[v] += -by_coordinate(step, change[v]);
    }
    before = now;
  }
  return moves;
}

double mean_edge(const Columns& positions, const Connectivity& connectivity) {
  NeumaierSum sum;
  double count = 0.0;
  for (Index v = 0; v < positions.size(); ++v) {
    for (const Index w : connectivity.ring(v)) {
      if (w < v) continue;
      sum.add(norm(positions[w] - positions[v]));
      count += 1.0;
    }
  }
  return count > 0.0 ? sum.value() / count : 0.0;
}

bool is_finite(Vec3 p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

}  // namespace

std::vector<Vec3> smoothed_positions(const Patch& patch, std::optional<double> wave) {
  const std::span<const Index> inner = patch.inner_vertices();
  if (inner.empty()) return patch.positions();
  const double scale = patch.unit_scale();
  const auto scaled = [&] {
    Columns positions = patch.positions();
    for (Vec3& p : positions)
      p = scale * p;
    return positions;
  };
  const double edge = mean_edge(scaled(), patch.connectivity());
  if (wave) check_range("smooth_first", *wave, {0.0, k_longest_wave * edge / scale});
  const double length = wave ? *wave * scale : k_usual_wave * edge;
  const double root = 0.5 * length / std::numbers::pi, edges = length / (k_usual_wave * edge);
  const auto most_steps = static_cast<int>(k_most_steps * std::max(1.0, edges * edges));
  InnerRows rows = rows_of(scaled(), patch.connectivity());
  const Columns moves = moves_of(std::move(rows), root * root * root * root, most_steps);
  if (!std::all_of(moves.begin(), moves.end(), is_finite)) return patch.positions();
  std::vector<Vec3> result = patch.positions();
  for (std::size_t i = 0; i < inner.size(); ++i) {
    const Vec3 place = scale * patch.positions()[inner[i]] + moves[i];
    result[inner[i]] = {place.x / scale, place.y / scale, place.z / scale};
  }
  return result;
}

double design_bending(const Patch& patch) {
  const Patch smooth = patch.with_positions(smoothed_positions(patch));
  const double bending = std::min(measure_bending(patch).bending, measure_bending(smooth).bending);
  return bending < k_no_bending ? 0.0 : bending;
}

}  // namespace planish
