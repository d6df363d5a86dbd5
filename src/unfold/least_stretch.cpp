#include "unfold/least_stretch.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "solve/sparse_ldlt.h"
#include "unfold/flat_steps.h"

namespace planish {

namespace {

/// The gradient and the Hessian (lower half) of the whole disk.
class NewtonSystem {
 public:
  explicit NewtonSystem(const Disk& disk) : disk_(disk), unknowns_(disk) {
    make_pattern();
    gradient_.resize(unknowns_.count());
    for (const Triangle& t : disk.triangles)
      for_pairs(t, [&](int row, int column, int, int) { slots_.push_back(slot(row, column)); });
  }

  void assemble(const std::vector<Vec2>& flat, Curvature curvature) {
    std::fill_n(hessian_.valuePtr(), hessian_.nonZeros(), 0.0);
    gradient_.setZero();
    auto next_slot = slots_.begin();
    for (std::size_t t = 0; t < disk_.triangles.size(); ++t) {
      const TriangleEnergy energy = energy_of(disk_, t, flat);
      const auto gradient = energy.gradient();
      const auto hessian = energy.hessian(curvature);
      const Triangle& tri = disk_.triangles[t];
      for (int i = 0; i < 6; ++i) {
        const int row = unknowns_.column(tri[i / 2], i % 2);
        if (row != Unknowns::k_fixed) gradient_[row] += gradient[i];
      }
      for_pairs(
          tri, [&](int, int, int i, int j) { hessian_.valuePtr()[*next_slot++] += hessian[i][j]; });
    }
  }

  bool solved_by(const Eigen::VectorXd& step) const {
    const Eigen::VectorXd residual = hessian_.selfadjointView<Eigen::Lower>() * step + gradient_;
    return residual.norm() <= 0.1 * gradient_.norm();
  }
  const SparseMatrix& hessian() const { return hessian_; }
  const Eigen::VectorXd& gradient() const { return gradient_; }
  std::vector<Vec2> spread(const Eigen::VectorXd& unknowns) const {
    std::vector<Vec2> at(disk_.vertex_count);
    for (Index v = 0; v < disk_.vertex_count; ++v) {
      const int x = unknowns_.column(v, 0), y = unknowns_.column(v, 1);
      at[v] = {x == Unknowns::k_fixed ? 0.0 : unknowns[x],
               y == Unknowns::k_fixed ? 0.0 : unknowns[y]};
    }
    return at;
  }

 private:
  /// Two unknowns meet where their vertices share a triangle.
  void make_pattern() {
    std::vector<Eigen::Triplet<char>> pairs;
    for (const Triangle& t : disk_.triangles) {
      for (int k = 0; k < 3; ++k) {
        pairs.emplace_back(t[k], t[k], 1);
        pairs.emplace_back(std::max(t[k], t[(k + 1) % 3]), std::min(t[k], t[(k + 1) % 3]), 1);
      }
    }
    const auto n = static_cast<Eigen::Index>(disk_.vertex_count);
    Eigen::SparseMatrix<char> meet(n, n);
    meet.setFromTriplets(pairs.begin(), pairs.end(), [](char a, char) { return a; });
    hessian_.resize(unknowns_.count(), unknowns_.count());
    hessian_.reserve(4 * meet.nonZeros());
    for (Index v = 0; v < disk_.vertex_count; ++v) {
      for (const int column : {unknowns_.column(v, 0), unknowns_.column(v, 1)}) {
        if (column == Unknowns::k_fixed) continue;
        hessian_.startVec(column);
        for (Eigen::SparseMatrix<char>::InnerIterator w(meet, v); w; ++w) {
          for (const int axis : {0, 1}) {
            const int row = unknowns_.column(static_cast<Index>(w.row()), axis);
            if (row >= column) hessian_.insertBack(row, column) = 0.0;
          }
        }
      }
    }
    hessian_.finalize();
  }

  template <class Visit>
  void for_pairs(const Triangle& tri, Visit visit) const {
    for (int i = 0; i < 6; ++i) {
      const int row = unknowns_.column(tri[i / 2], i % 2);
      for (int j = 0; j < 6; ++j) {
        const int column = unknowns_.column(tri[j / 2], j % 2);
        if (column != Unknowns::k_fixed && row >= column) visit(row, column, i, j);
      }
    }
  }

  int slot(int row, int column) const {
    const int* rows = hessian_.innerIndexPtr();
    const int* found = std::lower_bound(rows + hessian_.outerIndexPtr()[column],
                                        rows + hessian_.outerIndexPtr()[column + 1], row);
    return static_cast<int>(found - rows);
  }

  const Disk& disk_;
  Unknowns unknowns_;
  SparseMatrix hessian_;
  std::vector<int> slots_;  // where entries go among its values, in the order that they are made in
  Eigen::VectorXd gradient_;
};

/// Finds one Newton step after another with a factor of one of their matrices.
class LaggedSolver {
 public:
  explicit LaggedSolver(ThreadPool& pool) : pool_(pool) {}

  /// The step from there, of which the system is left as solved; an empty vector where the matrix
  /// cannot be factored.
  Eigen::VectorXd step(NewtonSystem& system, const std::vector<Vec2>& flat) {
    if (factored_) {
      system.assemble(flat, Curvature::full);
      auto step = conjugate_gradients(system.hessian(), -system.gradient());
      if (step.size() > 0) return step;
    }
    system.assemble(flat, Curvature::projected);
    if (!factor_) factor_.emplace(system.hessian());
    factored_ = factor_->factor(system.hessian(), pool_);
    if (!factored_) return {};
    return factor_->solve(-system.gradient(), pool_);
  }

 private:
  /// Preconditioned with the factor at hand; empty if that takes too many steps.
  Eigen::VectorXd conjugate_gradients(const SparseMatrix& lower, const Eigen::VectorXd& right) {
    constexpr int most_steps = 12;
    constexpr double enough = 1e-2;  // of the residual: Newton's own error is of that kind
    const auto matrix = lower.selfadjointView<Eigen::Lower>();
    Eigen::VectorXd x = Eigen::VectorXd::Zero(right.size());
    Eigen::VectorXd residual = right, z = factor_->solve(residual, pool_), direction = z;
    double rz = residual.dot(z);
    const double first = rz;
    for (int step = 0; step < most_steps; ++step) {
      const Eigen::VectorXd image = matrix * direction;
      const double length = rz / direction.dot(image);
      if (!std::isfinite(length) || length <= 0.0) return {};
      x += length * direction;
      residual -= length * image;
      z = factor_->solve(residual, pool_);
      const double next = residual.dot(z);
      if (next <= enough * enough * first) return x;
      direction = z + (next / rz) * direction;
      rz = next;
    }
    return {};
  }

  ThreadPool& pool_;
  std::optional<SparseLdlt> factor_;
  bool factored_ = false;
};

}  // namespace

LeastStretch minimise_stretch(const Disk& disk, std::vector<Vec2> start, int max_iterations,
                              ThreadPool& pool, const std::function<bool(int, double)>& on_step) {
  // A stretch of 1e-9 everywhere is none; and what a further step would gain must be worth it.
  constexpr double no_energy = 4e-18, least_gain = 1e-6, least_fall = 1e-4;
  LeastStretch result{turn_to_axis(disk, std::move(start)), 0, false};
  NewtonSystem system(disk);
  LaggedSolver solver(pool);
  double energy = total_energy(disk, result.flat);
  for (; result.iterations < max_iterations; ++result.iterations) {
    if ((result.converged = energy <= no_energy)) break;
    const Eigen::VectorXd step = solver.step(system, result.flat);
    if (step.size() == 0) break;
    const double slope = system.gradient().dot(step);
    if (!(slope < 0.0) || -slope <= least_gain * energy) {
      // Only a step that does solve the system tells that there is nothing left to gain.
      result.converged = system.solved_by(step);
      break;
    }
    const std::vector<Vec2> move = system.spread(step);
    double share = std::min(1.0, 0.9 * step_to_first_flip(disk, result.flat, move));
    bool fell = false;
    for (int halvings = 0; halvings < 40 && !fell; ++halvings, share *= 0.5) {
      std::vector<Vec2> trial = moved(result.flat, share, move);
      const double trial_energy = total_energy(disk, trial);
      fell = trial_energy <= energy + 1e-4 * share * slope;
      if (!fell) continue;
      result.flat = std::move(trial);
      energy = trial_energy;
    }
    if (!fell) {
      result.converged = -slope <= least_fall * energy;  // rounding is all that is left
      break;
    }
    if (on_step && !on_step(result.iterations + 1, energy)) break;
  }
  return result;
}

}  // namespace planish
