#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "core/thread_pool.h"
#include "energy/angle_jacobian.h"
#include "evolve/systems/dense.h"
#include "evolve/systems/positions.h"
#include "optimize/block.h"
#include "optimize/block_matrix.h"
#include "solve/mixed_ldlt.h"

namespace planish {

/// Moves dx of all vertices that may move, and multipliers y of the inner ones and of holes:
///
///     [ H   J^T  ] [dx]   [force]
///     [ J  -c S  ] [ y] = [dtheta]
///
/// H a sum of terms, J = d d / d x the Jacobian of the defects (minus that of the angle sums), S a
/// positive definite matrix over its rows. Quasi-definite, so factored without pivots,
/// under a dissection of the mesh. A vertex moves in all three directions, or along one: steps
/// along one direction have half of the unknowns and a quarter of the memory.
class KktSystem {
 public:
  /// In how many directions vertices move: 3 along the axes, 1 along a direction that is given.
  struct Moves {
    int inner = 3, border = 3;
  };
  using ForPairs = BlockMatrix::ForPairs;

  /// @param for_pairs of the vertices of every term of H
  /// @param square the lower half of S; its pattern stays
  /// @param jacobian must outlive it
  /// @throws Cancelled
  KktSystem(const AngleJacobian& jacobian, const PatchState& state, const ForPairs& for_pairs,
            const SparseMatrix& square, Moves moves, Precision precision, const ThreadPool& pool);

  /// The pairs of a term's vertices i < j in lexical order, for terms that are added often.
  template <std::size_t n>
  void append_pairs(const std::array<Index, n>& vertices,
                    std::vector<BlockMatrix::Pair>& pairs) const {
    BlockMatrix::for_each_pair(n, [&](std::size_t i, std::size_t j) {
      pairs.push_back(pair_of(vertices[i], vertices[j]));
    });
  }

  /// Everything in H is zero.
  /// @param directions of those vertices that move along one, in their order, of length 1
  /// @param unit of length of dx
  void clear(std::vector<Vec3> directions = {}, double unit = 1.0);
  /// Adds s g g^T for the gradient of a function of some vertices.
  template <std::size_t n>
  void add_term(const std::array<Index, n>& vertices, double scale,
                const std::array<Vec3, n>& gradient) {
    add_term(vertices, scale, gradient, [&](std::size_t, std::size_t i, std::size_t j) {
      return pair_of(vertices[i], vertices[j]);
    });
  }
  /// The same with the pairs as append_pairs() gave them.
  template <std::size_t n>
  void add_term(const std::array<Index, n>& vertices, const BlockMatrix::Pair* pairs, double scale,
                const std::array<Vec3, n>& gradient) {
    add_term(vertices, scale, gradient,
             [pairs](std::size_t number, std::size_t, std::size_t) { return pairs[number]; });
  }
  /// Adds a matrix to what a vertex has with itself.
  void add_vertex(Index v, const Block& block);
  /// Adds s a times the identity of three rows to what two vertices have with one another.
  /// @param pair of the two, as append_pairs() gave it
  void add_scalar(Index v, Index w, BlockMatrix::Pair pair, double scale, double value);

  /// Factors; false where that cannot be. J is that of the gradients as they are.
  bool factor(const SparseMatrix& square, double c, ThreadPool& pool);

  /// @return dx, zero of what may not move. @pre factor() was true
  /// @param force by column of the jacobian
  /// @param angle_change by row of the jacobian
  /// @param accuracy as of MixedLdlt
  Positions solve(const Positions& force, const Eigen::VectorXd& angle_change, ThreadPool& pool,
                  double accuracy = k_step_accuracy);

  /// Frees the factor, until the next one is made.
  void release() { solver_->release(); }
  /// Whether float did not do for the last matrix.
  bool fell_back() const { return solver_->fell_back(); }

 private:
  template <std::size_t n, class PairOf>
  void add_term(const std::array<Index, n>& vertices, double scale,
                const std::array<Vec3, n>& gradient, PairOf pair_at) {
    for (std::size_t i = 0; i < n; ++i)
      add_own(vertices[i], scale, gradient[i]);
    std::size_t number = 0;
    BlockMatrix::for_each_pair(n, [&](std::size_t i, std::size_t j) {
      const std::size_t k = number++;
      if (!jacobian_.is_movable(vertices[i]) || !jacobian_.is_movable(vertices[j])) return;
      const auto [first, second] = vertices[i] < vertices[j] ? std::pair{i, j} : std::pair{j, i};
      add_product(vertices[first], vertices[second], pair_at(k, i, j), scale, gradient[second],
                  gradient[first]);
    });
  }

  /// The blocks of a vertex: its moves, and of inner ones the multiplier behind them. Those of the
  /// rows of holes are behind all others.
  Index moves_of(Index v) const { return v < inner_ ? 2 * v : inner_ + v; }
  Index multiplier_of(Index row) const { return row < inner_ ? 2 * row + 1 : count_ + row; }
  int move_count(Index v) const { return v < inner_ ? moves_.inner : moves_.border; }
  BlockMatrix::Pair pair_of(Index v, Index w) const {
    return v < count_ && w < count_ ? matrix_.pair_of(moves_of(v), moves_of(w))
                                    : BlockMatrix::k_none;
  }
  Vec3 direction(Index v) const {
    return directions_[v < inner_ || moves_.inner == 1 ? v : v - inner_];
  }
  /// A vector's parts in the directions of the moves of a vertex.
  std::array<double, 3> along_moves(Index v, Vec3 a) const {
    if (move_count(v) == 1) return {dot(direction(v), a)};
    return {a.x, a.y, a.z};
  }
  Vec3 move_of(Index v, const Eigen::VectorXd& solution) const;
  BlockMatrix matrix_with(const ForPairs& for_pairs, const SparseMatrix& square) const;
  std::vector<Index> elimination_order(const PatchState& state) const;
  void add_product(Index first, Index second, BlockMatrix::Pair pair, double scale, Vec3 rows,
                   Vec3 columns);
  void add_own(Index v, double scale, Vec3 gradient);
  void fill_jacobian();
  void fill_square(const SparseMatrix& square, double c);

  const AngleJacobian& jacobian_;
  Index inner_, count_;
  Moves moves_;
  std::vector<Vec3> directions_;
  double unit_ = 1.0;
  BlockMatrix matrix_;
  std::optional<MixedLdlt> solver_;
};

}  // namespace planish
