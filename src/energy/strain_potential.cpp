#include "energy/strain_potential.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/neumaier_sum.h"
#include "geometry/cotangents.h"
#include "solve/dissection.h"
#include "solve/sparse_pattern.h"

namespace planish {

namespace {

constexpr std::size_t k_nowhere = std::numeric_limits<std::size_t>::max();
constexpr std::size_t k_grain = 512;
constexpr double k_accuracy = 1e-8;  // of chi, on dense patches

/// K without values.
SparseMatrix pattern_of(const AngleJacobian& jacobian, const MirrorOrbits& orbits,
                        std::size_t rows) {
  const std::size_t n = orbits.count(jacobian.row_count());
  return sparse_matrix(rows, n, [&](const auto& add) {
    for (Index v = 0; v < jacobian.angle_count(); ++v) {
      add(v, orbits.orbit_of(v), 0.0);
      for (const Index w : jacobian.ring(v)) {
        if (w < rows) add(w, orbits.orbit_of(v), 0.0);
      }
    }
    for (std::size_t column = jacobian.angle_count(); column < n; ++column) {
      for (const Index w : jacobian.holes()[(column - jacobian.angle_count()) / 3].around)
        add(w, column, 0.0);
    }
  });
}

/// Among the values; k_nowhere where the entry is not there.
std::size_t place_in_column(const SparseMatrix& matrix, int row, int column) {
  const int* rows = matrix.innerIndexPtr();
  const int* end = rows + matrix.outerIndexPtr()[column + 1];
  const int* found = std::lower_bound(rows + matrix.outerIndexPtr()[column], end, row);
  return found != end && *found == row ? static_cast<std::size_t>(found - rows) : k_nowhere;
}

double dot_of_columns(const SparseMatrix& matrix, int a, int b) {
  double sum = 0.0;
  SparseMatrix::InnerIterator x(matrix, a), y(matrix, b);
  while (x && y) {
    if (x.row() == y.row()) {
      sum += x.value() * y.value();
      ++x;
      ++y;
    } else if (x.row() < y.row()) {
      ++x;
    } else {
      ++y;
    }
  }
  return sum;
}

}  // namespace

StrainPotential::StrainPotential(const AngleJacobian& jacobian, std::span<const Vec3> x,
                                 ThreadPool& pool, BoundaryCondition border, Precision precision,
                                 MirrorOrbits orbits)
    : jacobian_(jacobian),
      orbits_(std::move(orbits)),
      border_(border),
      stiffness_(pattern_of(jacobian, orbits_,
                            border == BoundaryCondition::free ? x.size() : jacobian.row_count())) {
  const std::size_t n = jacobian.row_count();
  if (n == 0) return;
  for (const HoleBorder& hole : jacobian.holes()) {
    is_at_hole_.resize(x.size(), 0);
    for (const Index b : hole.loop)
      is_at_hole_[b] = 1;
  }
  fill(x, pool);
  const SparseMatrix square = SparseMatrix(stiffness_.transpose()) * stiffness_;
  square_ = square.triangularView<Eigen::Lower>();
  pool.stop_if_cancelled();
  solver_.emplace(matrix(), elimination_order(x), precision, &pool);
  solvable_ = solver_->factor(matrix(), pool);
}

/// The rows of the holes, which meet many others, come last.
std::vector<Index> StrainPotential::elimination_order(std::span<const Vec3> x) const {
  const std::size_t count = orbits_.count(jacobian_.angle_count());
  const auto n = static_cast<Eigen::Index>(count);
  const SparseMatrix of_vertices = matrix().topLeftCorner(n, n);
  std::vector<Vec3> places;
  for (Index orbit = 0; orbit < count; ++orbit)
    places.push_back(x[orbits_.first_of(orbit)]);
  std::vector<Index> order =
      nested_dissection(places, graph_of(of_vertices.selfadjointView<Eigen::Lower>()));
  for (std::size_t row = jacobian_.angle_count(); row < jacobian_.row_count(); ++row)
    order.push_back(static_cast<Index>(row));
  return order;
}

void StrainPotential::fill(std::span<const Vec3> x, ThreadPool& pool) {
  double* values = stiffness_.valuePtr();
  const int* start = stiffness_.outerIndexPtr();
  const std::size_t count = orbits_.count(jacobian_.angle_count());
  pool.for_ranges(count, k_grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t orbit = begin; orbit < end; ++orbit) {
      const int column = static_cast<int>(orbit);
      std::fill(values + start[column], values + start[column + 1], 0.0);
      const Index v = orbits_.first_of(static_cast<Index>(orbit)), image = orbits_.image(v);
      add_row(v, column, x);
      if (image != v) add_row(image, column, x);
    }
  });
  polygons_.clear();
  for (std::size_t hole = 0; hole < jacobian_.holes().size(); ++hole)
    fill_hole(hole, x);
}

/// The row of K of an inner vertex.
void StrainPotential::add_row(Index v, int column, std::span<const Vec3> x) {
  const auto neighbours = jacobian_.ring(v);
  std::vector<Vec3> ring;
  for (const Index w : neighbours)
    ring.push_back(x[w]);
  const std::vector<double> weights = cotangent_weights(x[v], ring);
  const double at_border = std::sqrt(ease_);
  double* values = stiffness_.valuePtr();
  double& own = values[place_in_column(stiffness_, static_cast<int>(v), column)];
  for (std::size_t j = 0; j < weights.size(); ++j) {
    own += weights[j];
    const std::size_t place = place_in_column(stiffness_, static_cast<int>(neighbours[j]), column);
    if (place == k_nowhere) continue;
    values[place] += is_eased(neighbours[j]) ? -at_border * weights[j] : -weights[j];
  }
}

/// The rows of K at its border, summed, and weighed by the corners of its polygon, less what phi
/// does to the lengths of its edges.
void StrainPotential::fill_hole(std::size_t hole, std::span<const Vec3> x) {
  const HoleBorder& border = jacobian_.holes()[hole];
  const auto at = [&](Index v) { return x[v]; };
  const HoleLayout::Polygon& polygon = polygons_.emplace_back(laid_out(border, at).closed());
  const int first = static_cast<int>(jacobian_.angle_count() + 3 * hole);
  const double at_outline = std::sqrt(ease_);
  double* values = stiffness_.valuePtr();
  const int* start = stiffness_.outerIndexPtr() + first;
  std::fill(values + start[0], values + start[3], 0.0);
  const auto add = [&](int column, Index v, double value) {
    values[place_in_column(stiffness_, static_cast<int>(v), first + column)] +=
        is_eased(v) ? at_outline * value : value;
  };
  for (std::size_t b = 0; b < border.loop.size(); ++b) {
    const Index v = border.loop[b];
    std::vector<Vec3> ring;
    for (const Index w : border.rings[b])
      ring.push_back(x[w]);
    const std::vector<double> weights = cotangent_weights(x[v], ring, RingEnds::open);
    const Vec2 place = polygon.places[b], normal = polygon.normals[b];
    for (std::size_t j = 0; j < weights.size(); ++j) {
      const Index w = border.rings[b][j];
      for (const auto& [column, factor] :
           {std::pair{0, 1.0}, std::pair{1, place.x}, std::pair{2, place.y}}) {
        add(column, v, factor * weights[j]);
        add(column, w, -factor * weights[j]);
      }
    }
    add(1, v, -normal.x);
    add(2, v, -normal.y);
  }
}

void StrainPotential::take_square(ThreadPool& pool) {
  const auto count = static_cast<std::size_t>(square_.cols());
  pool.for_ranges(count, k_grain, [this](std::size_t begin, std::size_t end) {
    for (int v = static_cast<int>(begin); v < static_cast<int>(end); ++v) {
      for (SparseMatrix::InnerIterator entry(square_, v); entry; ++entry)
        entry.valueRef() = dot_of_columns(stiffness_, static_cast<int>(entry.row()), v);
    }
  });
}

void StrainPotential::update(std::span<const Vec3> x, ThreadPool& pool) {
  if (!solver_) return;
  fill(x, pool);
  take_square(pool);
  factor(pool);
}

void StrainPotential::release() {
  if (solver_) solver_->release();
}

void StrainPotential::factor(ThreadPool& pool) {
  if (solver_) solvable_ = solver_->factor(matrix(), pool);
}

Eigen::VectorXd StrainPotential::of(const Eigen::VectorXd& defects, ThreadPool& pool) {
  Eigen::VectorXd right = Eigen::VectorXd::Zero(stiffness_.cols());
  for (Eigen::Index row = 0; row < defects.size(); ++row)
    right[orbits_.orbit_of(static_cast<Index>(row))] += defects[row];
  Eigen::VectorXd solution = solver_->solve(matrix(), right, pool, k_accuracy, k_accuracy);
  if (!by_square()) return solution;
  return stiffness_ * solution;
}

Eigen::VectorXd area_shares(std::span<const Triangle> triangles, std::span<const Vec3> x) {
  Eigen::VectorXd shares = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(x.size()));
  for (const Triangle& t : triangles) {
    const double area = norm(cross(x[t[1]] - x[t[0]], x[t[2]] - x[t[0]]));
    for (const Index v : t)
      shares[static_cast<Eigen::Index>(v)] += area;
  }
  NeumaierSum total;
  for (const double share : shares)
    total.add(share);
  return shares / total.value();
}

double edge_strain_of(double rms_potential) {
  return std::sqrt(3.0 / 8.0) * rms_potential;
}

}  // namespace planish
