#include "evolve/systems/fairing_system.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "geometry/cotangents.h"
#include "solve/dissection.h"
#include "solve/sparse_pattern.h"

namespace planish {

namespace {

std::vector<Vec3> places_of(const PatchState& state, std::span<const Index> vertices) {
  std::vector<Vec3> positions;
  for (const Index v : vertices)
    positions.push_back(state.position(v));
  return positions;
}

Eigen::RowVector3d row_of(Vec3 p) {
  return {p.x, p.y, p.z};
}

}  // namespace

std::vector<std::vector<double>> rows_of_laplacian(const PatchState& state, LaplacianWeights kind) {
  std::vector<std::vector<double>> rows;
  std::vector<double> areas;
  for (Index v = 0; const auto ring : rings_by_vertex(state.plan())) {
    if (kind == LaplacianWeights::uniform) {
      rows.emplace_back(ring.size(), 1.0 / static_cast<double>(ring.size()));
    } else {
      const std::vector<Vec3> positions = places_of(state, ring);
      rows.push_back(cotangent_weights(state.position(v), positions));
      areas.push_back(mixed_area(state.position(v), positions));
    }
    ++v;
  }
  if (kind == LaplacianWeights::uniform) return rows;
  const double mean =
      std::accumulate(areas.begin(), areas.end(), 0.0) / static_cast<double>(areas.size());
  for (std::size_t v = 0; v < rows.size(); ++v) {
    // A vertex without area would weigh without end.
    double scale = mean / std::max(areas[v], 1e-3 * mean);
    if (kind == LaplacianWeights::thin_plate) scale = std::sqrt(scale);
    for (double& weight : rows[v])
      weight *= scale;
  }
  return rows;
}

FairingSystem::FairingSystem(const PatchState& state, std::span<const unsigned char> movable,
                             LaplacianWeights kind, std::span<const double> weights,
                             ThreadPool& pool) {
  constexpr int held = -1;
  std::vector<int> number(state.vertex_count(), held);
  std::vector<Vec3> positions;
  for (Index v = 0; v < state.inner_count(); ++v) {
    if (movable[v] == 0) continue;
    number[v] = static_cast<int>(movable_.size());
    movable_.push_back(v);
    pull_.push_back(weights[v] * weights[v]);
    positions.push_back(state.position(v));
  }
  if (movable_.empty()) return;
  const auto count = static_cast<int>(movable_.size());
  const auto rings = rings_by_vertex(state.plan());
  const auto rows = rows_of_laplacian(state, kind);
  Eigen::MatrixXd g = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(rows.size()), 3);
  const SparseMatrix laplacian =
      sparse_matrix(rows.size(), movable_.size(), [&](const auto& add_entry) {
        for (Index v = 0; v < rows.size(); ++v) {
          const auto add = [&](Index w, double weight) {
            if (number[w] == held)
              g.row(v) += weight * row_of(state.position(w));
            else
              add_entry(v, static_cast<std::size_t>(number[w]), weight);
          };
          add(v, std::accumulate(rows[v].begin(), rows[v].end(), 0.0));
          for (std::size_t j = 0; j < rings[v].size(); ++j)
            add(rings[v][j], -rows[v][j]);
        }
      });
  SparseMatrix pull(count, count);
  held_share_ = laplacian.transpose() * g;
  pull.setIdentity();
  pull.diagonal() = Eigen::Map<const Eigen::VectorXd>(pull_.data(), count);
  const SparseMatrix normal = SparseMatrix(laplacian.transpose() * laplacian) + pull;
  const SparseMatrix lower = normal.triangularView<Eigen::Lower>();
  solver_.emplace(lower, nested_dissection(positions, graph_of(normal)));
  solvable_ = solver_->factor(lower, pool);
}

std::vector<Vec3> FairingSystem::apply(std::vector<Vec3> targets, ThreadPool& pool) const {
  Eigen::MatrixXd right = -held_share_;
  for (std::size_t i = 0; i < movable_.size(); ++i)
    right.row(static_cast<Eigen::Index>(i)) += pull_[i] * row_of(targets[movable_[i]]);
  const Eigen::MatrixXd positions = solver_->solve(right, pool);
  for (std::size_t i = 0; i < movable_.size(); ++i) {
    const auto row = positions.row(static_cast<Eigen::Index>(i));
    targets[movable_[i]] = {row[0], row[1], row[2]};
  }
  return targets;
}

}  // namespace planish
