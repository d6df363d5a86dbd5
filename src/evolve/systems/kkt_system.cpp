#include "evolve/systems/kkt_system.h"

#include <algorithm>
#include <utility>

#include "solve/dissection.h"

namespace planish {

KktSystem::KktSystem(const AngleJacobian& jacobian, const PatchState& state,
                     const ForPairs& for_pairs, const SparseMatrix& square, Moves moves,
                     Precision precision, const ThreadPool& pool)
    : jacobian_(jacobian),
      inner_(static_cast<Index>(jacobian.angle_count())),
      count_(static_cast<Index>(jacobian.column_count())),
      moves_(moves) {
  pool.stop_if_cancelled();
  matrix_ = matrix_with(for_pairs, square);
  pool.stop_if_cancelled();
  solver_.emplace(matrix_.lower(), elimination_order(state), precision, &pool);
}

BlockMatrix KktSystem::matrix_with(const ForPairs& for_pairs, const SparseMatrix& square) const {
  std::vector<unsigned char> sizes;
  for (Index v = 0; v < count_; ++v) {
    sizes.push_back(static_cast<unsigned char>(move_count(v)));
    if (v < inner_) sizes.push_back(1);
  }
  sizes.resize(sizes.size() + 3 * jacobian_.holes().size(), 1);
  return {sizes, [&](const BlockMatrix::VisitPair& visit) {
            for_pairs([&](Index v, Index w) {
              if (v < count_ && w < count_) visit(moves_of(v), moves_of(w));
            });
            for (Index v = 0; v < count_; ++v) {
              for (const AngleJacobian::Entry& entry : jacobian_.column(v))
                visit(moves_of(v), multiplier_of(entry.row));
            }
            for (int v = 0; v < square.outerSize(); ++v) {
              for (SparseMatrix::InnerIterator entry(square, v); entry; ++entry)
                visit(multiplier_of(static_cast<Index>(v)),
                      multiplier_of(static_cast<Index>(entry.row())));
            }
          }};
}

std::vector<Index> KktSystem::elimination_order(const PatchState& state) const {
  const auto vertex_of = [&](Index block) {
    return block < 2 * inner_ ? block / 2 : block - inner_;
  };
  std::vector<std::vector<Index>> neighbours(count_);
  const Index first_of_holes = inner_ + count_;
  for (Index block = 0; block < first_of_holes; ++block) {
    const Index v = vertex_of(block);
    matrix_.for_pairs_of(block, [&](Index other, BlockMatrix::Pair) {
      const Index w = vertex_of(other);
      if (other >= first_of_holes || v == w) return;
      neighbours[v].push_back(w);
      neighbours[w].push_back(v);
    });
  }
  Graph graph;
  for (std::vector<Index>& of_vertex : neighbours) {
    std::sort(of_vertex.begin(), of_vertex.end());
    const auto end = std::unique(of_vertex.begin(), of_vertex.end());
    graph.neighbours.insert(graph.neighbours.end(), of_vertex.begin(), end);
    graph.start.push_back(graph.neighbours.size());
  }
  std::vector<Index> order;
  for (const Index v : nested_dissection(first_positions(state, count_), graph)) {
    for (int part = 0; part < move_count(v); ++part)
      order.push_back(static_cast<Index>(matrix_.unknown(moves_of(v), part)));
    if (v < inner_) order.push_back(static_cast<Index>(matrix_.unknown(multiplier_of(v), 0)));
  }
  // The rows of holes meet many others.
  for (Index block = first_of_holes; block < matrix_.block_count(); ++block)
    order.push_back(static_cast<Index>(matrix_.unknown(block, 0)));
  return order;
}

void KktSystem::clear(std::vector<Vec3> directions, double unit) {
  directions_ = std::move(directions);
  unit_ = unit;
  matrix_.clear();
  for (Index v = 0; v < count_; ++v) {
    if (jacobian_.is_movable(v)) continue;
    for (int part = 0; part < move_count(v); ++part)
      *matrix_.own(moves_of(v), part) = 1.0;
  }
}

/// s a b^T: rows of the second vertex, columns of the first.
void KktSystem::add_product(Index first, Index second, BlockMatrix::Pair pair, double scale,
                            Vec3 rows, Vec3 columns) {
  const std::array<double, 3> by_column = along_moves(first, scale * columns),
                              by_row = along_moves(second, rows);
  const auto column_count = static_cast<std::size_t>(move_count(first)),
             row_count = static_cast<std::size_t>(move_count(second));
  for (std::size_t column = 0; column < column_count; ++column) {
    double* values = matrix_.entries(moves_of(first), pair, static_cast<int>(column));
    for (std::size_t row = 0; row < row_count; ++row)
      values[row] += by_column[column] * by_row[row];
  }
}

void KktSystem::add_own(Index v, double scale, Vec3 g) {
  add_vertex(v, {scale * g.x * g.x, scale * g.x * g.y, scale * g.x * g.z, scale * g.y * g.y,
                 scale * g.y * g.z, scale * g.z * g.z});
}

void KktSystem::add_vertex(Index v, const Block& block) {
  if (!jacobian_.is_movable(v)) return;
  const Index moves = moves_of(v);
  if (move_count(v) == 1) {
    const Vec3 a = direction(v);
    *matrix_.own(moves, 0) += a.x * (block.xx * a.x + 2.0 * (block.xy * a.y + block.xz * a.z)) +
                              a.y * (block.yy * a.y + 2.0 * block.yz * a.z) + a.z * block.zz * a.z;
    return;
  }
  double *x = matrix_.own(moves, 0), *y = matrix_.own(moves, 1), *z = matrix_.own(moves, 2);
  x[0] += block.xx;
  x[1] += block.xy;
  x[2] += block.xz;
  y[0] += block.yy;
  y[1] += block.yz;
  z[0] += block.zz;
}

void KktSystem::add_scalar(Index v, Index w, BlockMatrix::Pair pair, double scale, double value) {
  if (!jacobian_.is_movable(v) || !jacobian_.is_movable(w)) return;
  if (v == w) {
    for (int part = 0; part < move_count(v); ++part)
      *matrix_.own(moves_of(v), part) += scale * value;
    return;
  }
  constexpr std::array<Vec3, 3> axes = {{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}};
  const auto [first, second] = std::minmax(v, w);
  for (int column = 0; column < move_count(first); ++column) {
    const std::array<double, 3> along = along_moves(
        second, move_count(first) == 1 ? direction(first) : axes[static_cast<std::size_t>(column)]);
    double* values = matrix_.entries(moves_of(first), pair, column);
    for (std::size_t row = 0; row < static_cast<std::size_t>(move_count(second)); ++row)
      values[row] += scale * along[row] * value;
  }
}

/// J is minus the Jacobian of the angle sums.
void KktSystem::fill_jacobian() {
  for (Index v = 0; v < count_; ++v) {
    if (!jacobian_.is_movable(v)) continue;
    const Index moves = moves_of(v);
    for (const AngleJacobian::Entry& entry : jacobian_.column(v)) {
      const auto parts = along_moves(v, jacobian_.gradient(entry.entry));
      const Index multiplier = multiplier_of(entry.row);
      const BlockMatrix::Pair pair = matrix_.pair_of(moves, multiplier);
      for (int part = 0; part < move_count(v); ++part) {
        double& value = moves < multiplier ? *matrix_.entries(moves, pair, part)
                                           : matrix_.entries(multiplier, pair, 0)[part];
        value = -unit_ * parts[static_cast<std::size_t>(part)];
      }
    }
  }
}

void KktSystem::fill_square(const SparseMatrix& square, double c) {
  for (int v = 0; v < square.outerSize(); ++v) {
    const Index first = multiplier_of(static_cast<Index>(v));
    for (SparseMatrix::InnerIterator entry(square, v); entry; ++entry) {
      const Index second = multiplier_of(static_cast<Index>(entry.row()));
      double* value = first == second ? matrix_.own(first, 0)
                                      : matrix_.entries(first, matrix_.pair_of(first, second), 0);
      *value = -c * entry.value();
    }
  }
}

bool KktSystem::factor(const SparseMatrix& square, double c, ThreadPool& pool) {
  fill_jacobian();
  fill_square(square, c);
  return solver_->factor(matrix_.lower(), pool);
}

Positions KktSystem::solve(const Positions& force, const Eigen::VectorXd& angle_change,
                           ThreadPool& pool, double accuracy) {
  Eigen::VectorXd right = Eigen::VectorXd::Zero(matrix_.lower().rows());
  for (Index row = 0; row < jacobian_.row_count(); ++row)
    right[matrix_.unknown(multiplier_of(row), 0)] = angle_change[row];
  for (Index v = 0; v < count_; ++v) {
    if (!jacobian_.is_movable(v)) continue;
    const std::array<double, 3> parts = along_moves(v, force[v]);
    for (int part = 0; part < move_count(v); ++part)
      right[matrix_.unknown(moves_of(v), part)] = parts[static_cast<std::size_t>(part)];
  }
  const Eigen::VectorXd solution = solver_->solve(matrix_.lower(), right, pool, accuracy);
  Positions step(count_);
  for (Index v = 0; v < count_; ++v) {
    if (jacobian_.is_movable(v)) step[v] = move_of(v, solution);
  }
  return step;
}

Vec3 KktSystem::move_of(Index v, const Eigen::VectorXd& solution) const {
  const auto part = [&](int number) { return solution[matrix_.unknown(moves_of(v), number)]; };
  if (move_count(v) == 1) return (unit_ * part(0)) * direction(v);
  return unit_ * Vec3{part(0), part(1), part(2)};
}

}  // namespace planish
