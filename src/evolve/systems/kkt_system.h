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
#include "mesh/symmetry/mirror_orbits.h"
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
///
/// For a patch that is its own mirror image, the system is reduced to symmetric moves: dx = P z and
/// y = Q eta, with one unknown for each orbit:
///
///     [ P^T H P   P^T J^T Q  ] [ z ]   [P^T force ]
///     [ Q^T J P  -c Q^T S Q  ] [eta] = [Q^T dtheta]
class KktSystem {
 public:
  /// In how many directions vertices move: 3 along the axes, 1 along a direction that is given.
  struct Moves {
    int inner = 3, border = 3;
  };
  using ForPairs = BlockMatrix::ForPairs;

  /// @param for_pairs of the vertices of every term of H
  /// @param square the lower half of S, or of Q^T S Q by orbits; its pattern stays
  /// @param jacobian must outlive it
  /// @param orbits symmetric only where there are no holes
  /// @throws Cancelled
  KktSystem(const AngleJacobian& jacobian, const PatchState& state, const ForPairs& for_pairs,
            const SparseMatrix& square, Moves moves, Precision precision, const ThreadPool& pool,
            MirrorOrbits orbits = {});

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
  /// A gradient by orbit. Where a term has both vertices of an orbit, the first one has both parts.
  template <std::size_t n>
  struct ByOrbit {
    std::array<Index, n> orbits;
    std::array<Vec3, n> gradient;
    std::array<bool, n> counts;
  };
  template <std::size_t n>
  ByOrbit<n> by_orbit(const std::array<Index, n>& vertices,
                      const std::array<Vec3, n>& gradient) const {
    ByOrbit<n> term;
    for (std::size_t i = 0; i < n; ++i) {
      term.orbits[i] = orbits_.orbit_of(vertices[i]);
      term.counts[i] = is_movable(vertices[i]);
      term.gradient[i] = orbits_.carried(vertices[i], gradient[i]);
      for (std::size_t j = 0; j < i && orbits_.is_symmetric(); ++j) {
        if (!term.counts[i] || !term.counts[j] || term.orbits[i] != term.orbits[j]) continue;
        term.gradient[j] += term.gradient[i];
        term.counts[i] = false;
      }
    }
    return term;
  }
  template <std::size_t n, class PairOf>
  void add_term(const std::array<Index, n>& vertices, double scale,
                const std::array<Vec3, n>& gradient, PairOf pair_at) {
    const ByOrbit<n> term = by_orbit(vertices, gradient);
    for (std::size_t i = 0; i < n; ++i) {
      if (term.counts[i]) add_own(term.orbits[i], scale, term.gradient[i]);
    }
    std::size_t number = 0;
    BlockMatrix::for_each_pair(n, [&](std::size_t i, std::size_t j) {
      const std::size_t k = number++;
      if (!term.counts[i] || !term.counts[j]) return;
      const auto [first, second] =
          term.orbits[i] < term.orbits[j] ? std::pair{i, j} : std::pair{j, i};
      add_product(term.orbits[first], term.orbits[second], pair_at(k, i, j), scale,
                  term.gradient[second], term.gradient[first]);
    });
  }

  bool is_movable(Index v) const {
    return jacobian_.is_movable(v) && jacobian_.is_movable(orbits_.image(v));
  }
  /// The blocks of an orbit: its moves, and of inner ones the multiplier behind them. Those of the
  /// rows of holes are behind all others.
  Index moves_of(Index orbit) const { return orbit < inner_ ? 2 * orbit : inner_ + orbit; }
  Index multiplier_of(Index orbit) const { return orbit < inner_ ? 2 * orbit + 1 : count_ + orbit; }
  int move_count(Index orbit) const { return orbit < inner_ ? moves_.inner : moves_.border; }
  /// Of two vertices.
  BlockMatrix::Pair pair_of(Index v, Index w) const {
    const Index first = orbits_.orbit_of(v), second = orbits_.orbit_of(w);
    return first < count_ && second < count_ ? matrix_.pair_of(moves_of(first), moves_of(second))
                                             : BlockMatrix::k_none;
  }
  /// That of the first vertex of an orbit.
  Vec3 direction(Index orbit) const {
    return directions_[orbit < inner_ || moves_.inner == 1 ? orbit : orbit - inner_];
  }
  /// The parts of a vector at the first vertex of an orbit in the directions of its moves.
  std::array<double, 3> along_moves(Index orbit, Vec3 a) const {
    if (move_count(orbit) == 1) return {dot(direction(orbit), a)};
    return {a.x, a.y, a.z};
  }
  /// Likewise of a vector at any vertex.
  std::array<double, 3> along_moves_at(Index v, Vec3 a) const {
    return along_moves(orbits_.orbit_of(v), orbits_.carried(v, a));
  }
  /// The unit vector along which a vertex moves with unknown `part` of its orbit.
  Vec3 unit_move(Index v, int part) const;
  std::vector<Vec3> directions_by_orbit(std::vector<Vec3> directions) const;
  void hold_unused_moves();
  Vec3 move_of(Index v, const Eigen::VectorXd& solution) const;
  BlockMatrix matrix_with(const ForPairs& for_pairs, const SparseMatrix& square) const;
  std::vector<Index> elimination_order(const PatchState& state) const;
  void add_product(Index first, Index second, BlockMatrix::Pair pair, double scale, Vec3 rows,
                   Vec3 columns);
  void add_own(Index orbit, double scale, Vec3 gradient);
  void add_block(Index orbit, const Block& block);
  void fill_jacobian();
  void fill_square(const SparseMatrix& square, double c);

  const AngleJacobian& jacobian_;
  MirrorOrbits orbits_;
  Index inner_, count_;  // orbits of inner vertices, of all columns
  Moves moves_;
  std::vector<Vec3> directions_;  // of the orbits that move along one, in their order
  double unit_ = 1.0;
  BlockMatrix matrix_;
  std::optional<MixedLdlt> solver_;
};

}  // namespace planish
