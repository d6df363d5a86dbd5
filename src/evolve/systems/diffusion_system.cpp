#include "evolve/systems/diffusion_system.h"

#include <algorithm>
#include <cmath>

#include "geometry/cotangents.h"
#include "solve/dissection.h"
#include "solve/sparse_pattern.h"

namespace planish {

namespace {

/// A triangle's area counts as at least this share of the square of its longest side: the gradients
/// of a needle would have no bound.
constexpr double k_thinnest = 1e-6;

constexpr int k_held_corner = -1;

/// The sides of a triangle, each opposite its corner, the unit normal and twice the area.
struct Sides {
  std::array<Vec3, 3> side;
  Vec3 normal;
  double doubled_area;
};

Sides sides_of(const std::array<Vec3, 3>& p) {
  Sides s{{p[2] - p[1], p[0] - p[2], p[1] - p[0]}, {}, 0.0};
  const Vec3 normal = cross(s.side[1], s.side[2]);
  const double area = norm(normal);
  double longest = 0.0;
  for (const Vec3 side : s.side)
    longest = std::max(longest, dot(side, side));
  if (area > 0.0) s.normal = (1.0 / area) * normal;
  s.doubled_area = std::max(area, 2.0 * k_thinnest * longest);
  return s;
}

/// A grad phi_i . a grad phi_j. grad phi_i is the opposite side, turned, over twice the area; its
/// part along a direction is that of the side across the direction, but for a sign that both have.
double stiffness(const Sides& s, const Diffusivity& a, std::size_t i, std::size_t j) {
  const Vec3 across = cross(s.normal, a.direction);
  const double squared = dot(across, across), more = a.along - a.across;
  double product = a.across * dot(s.side[i], s.side[j]);
  if (squared > 0.0) product += more / squared * dot(across, s.side[i]) * dot(across, s.side[j]);
  return product / (2.0 * s.doubled_area);
}

double mass_of(const PatchState& state, Index v, std::span<const Index> ring) {
  std::vector<Vec3> positions;
  for (const Index w : ring)
    positions.push_back(state.position(w));
  return mixed_area(state.position(v), positions);
}

}  // namespace

DiffusionSystem::DiffusionSystem(const PatchState& state, std::span<const unsigned char> movable,
                                 std::span<const double> weights, double rate,
                                 const DiffusivityOf& diffusivity, ThreadPool& pool) {
  std::vector<int> number(state.vertex_count(), k_held_corner);
  std::vector<Vec3> positions;
  const auto rings = rings_by_vertex(state.plan());
  for (Index v = 0; v < state.inner_count(); ++v) {
    if (movable[v] == 0) continue;
    number[v] = static_cast<int>(movable_.size());
    movable_.push_back(v);
    mass_.push_back(rate * weights[v] * weights[v] * mass_of(state, v, rings[v]));
    positions.push_back(state.position(v));
  }
  if (movable_.empty()) return;
  const auto count = static_cast<Eigen::Index>(movable_.size());
  held_share_ = Eigen::MatrixXd::Zero(count, 3);
  const SparseMatrix matrix =
      sparse_matrix(movable_.size(), movable_.size(), [&](const auto& add_entry) {
        for (std::size_t i = 0; i < mass_.size(); ++i)
          add_entry(i, i, mass_[i]);
        for (const Triangle& t : state.triangles()) {
          const Sides s =
              sides_of({state.position(t[0]), state.position(t[1]), state.position(t[2])});
          const Diffusivity a = diffusivity(t);
          for (std::size_t i = 0; i < 3; ++i) {
            const int row = number[t[i]];
            for (std::size_t j = 0; j < 3 && row != k_held_corner; ++j) {
              const double entry = stiffness(s, a, i, j);
              const Vec3 p = state.position(t[j]);
              if (number[t[j]] == k_held_corner)
                held_share_.row(row) += entry * Eigen::RowVector3d(p.x, p.y, p.z);
              else
                add_entry(static_cast<std::size_t>(row), static_cast<std::size_t>(number[t[j]]),
                          entry);
            }
          }
        }
      });
  const SparseMatrix lower = matrix.triangularView<Eigen::Lower>();
  solver_.emplace(lower, nested_dissection(positions, graph_of(matrix)));
  solvable_ = solver_->factor(lower, pool);
}

Positions DiffusionSystem::apply(Positions targets, ThreadPool& pool) const {
  Eigen::MatrixXd right = -held_share_;
  for (std::size_t i = 0; i < movable_.size(); ++i) {
    const Vec3 p = targets[movable_[i]];
    right.row(static_cast<Eigen::Index>(i)) += mass_[i] * Eigen::RowVector3d(p.x, p.y, p.z);
  }
  const Eigen::MatrixXd solution = solver_->solve(right, pool);
  for (std::size_t i = 0; i < movable_.size(); ++i) {
    const auto row = solution.row(static_cast<Eigen::Index>(i));
    targets[movable_[i]] = {row[0], row[1], row[2]};
  }
  return targets;
}

TriangleCurvature triangle_curvature(const std::array<Vec3, 3>& corners,
                                     const std::array<Vec3, 3>& normals) {
  const Sides s = sides_of(corners);
  const double length = norm(s.side[2]);
  if (s.normal == Vec3{} || length == 0.0) return {};
  const Vec3 first = (1.0 / length) * s.side[2], second = cross(s.normal, first);
  // Of the gradient of normals: how much turns towards a when going towards b.
  double aa = 0.0, ab = 0.0, bb = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 gradient = (1.0 / s.doubled_area) * cross(s.normal, s.side[i]);
    aa += dot(normals[i], first) * dot(gradient, first);
    bb += dot(normals[i], second) * dot(gradient, second);
    ab += 0.5 * (dot(normals[i], first) * dot(gradient, second) +
                 dot(normals[i], second) * dot(gradient, first));
  }
  const double mean = 0.5 * (aa + bb), half = 0.5 * (aa - bb);
  const double radius = std::sqrt(half * half + ab * ab);
  // The eigenvector of mean + radius, from the column that does not cancel.
  Vec3 direction =
      half >= 0.0 ? (half + radius) * first + ab * second : ab * first + (radius - half) * second;
  const double size = norm(direction);
  direction = size > 0.0 ? (1.0 / size) * direction : first;
  return {direction, mean + radius, mean - radius};
}

}  // namespace planish
