#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/thread_pool.h"
#include "evolve/systems/angle_jacobian.h"
#include "evolve/systems/dense.h"
#include "evolve/systems/positions.h"
#include "solve/mixed_ldlt.h"

namespace planish {

/// A symmetric matrix of three rows.
struct Block {
  double xx = 0.0, xy = 0.0, xz = 0.0, yy = 0.0, yz = 0.0, zz = 0.0;
};

/// Moves dx of all vertices that may move, and multipliers y of the inner ones:
///
///     [ H   J^T  ] [dx]   [force]
///     [ J  -c S  ] [ y] = [dtheta]
///
/// H a sum of terms, J = d d / d x the Jacobian of the defects (minus that of the angle sums), S a
/// positive definite matrix over the inner vertices. Quasi-definite, so factored without pivots,
/// under a dissection of the mesh. A vertex moves in all three directions, or along one: steps
/// along one direction have half of the unknowns and a quarter of the memory.
class KktSystem {
 public:
  /// In how many directions vertices move: 3 along the axes, 1 along a direction that is given.
  struct Moves {
    int inner = 3, border = 3;
  };
  using VisitPair = std::function<void(Index, Index)>;
  /// Calls visit(v, w) for the vertices of every term of H, as often as it likes.
  using ForPairs = std::function<void(const VisitPair& visit)>;

  /// @param square the lower half of S; its pattern stays
  /// @param jacobian must outlive it
  /// @throws Cancelled
  KktSystem(const AngleJacobian& jacobian, const PatchState& state, const ForPairs& for_pairs,
            const SparseMatrix& square, Moves moves, Precision precision, const ThreadPool& pool);

  /// Vertices of two numbers that share a term.
  using Pair = std::uint32_t;
  /// The pairs of a term's vertices i < j in lexical order, for terms that are added often.
  template <std::size_t n>
  void append_pairs(const std::array<Index, n>& vertices, std::vector<Pair>& pairs) const {
    for_each_pair(n, [&](std::size_t i, std::size_t j) {
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
  void add_term(const std::array<Index, n>& vertices, const Pair* pairs, double scale,
                const std::array<Vec3, n>& gradient) {
    add_term(vertices, scale, gradient,
             [pairs](std::size_t number, std::size_t, std::size_t) { return pairs[number]; });
  }
  /// Adds a matrix to what a vertex has with itself.
  void add_vertex(Index v, const Block& block);
  /// Adds s a times the identity of three rows to what two vertices have with one another.
  void add_scalar(Index v, Index w, double scale, double value);

  /// Factors; false where that cannot be. J is that of the gradients as they are.
  bool factor(const SparseMatrix& square, double c, ThreadPool& pool);

  /// @return dx, zero of what may not move. @pre factor() was true
  /// @param force by column of the jacobian
  /// @param angle_change by inner vertex
  /// @param accuracy as of MixedLdlt
  Positions solve(const Positions& force, const Eigen::VectorXd& angle_change, ThreadPool& pool,
                  double accuracy = k_step_accuracy);

  /// Frees the factor, until the next one is made.
  void release() { solver_->release(); }
  /// Whether float did not do for the last matrix.
  bool fell_back() const { return solver_->fell_back(); }

 private:
  static constexpr Pair k_none = ~Pair{0};

  /// Two vertices that share entries of the matrix; the first has the lower number. Entries of one
  /// column follow one another among the values.
  struct Entries {
    Index second = 0;
    // Where they start in the columns of the first vertex: of its first move, see start_of(), and
    // of its multiplier.
    std::uint32_t first_start = k_none, multiplier_start = 0;

    /// Or only between multipliers.
    bool is_full() const { return first_start != k_none; }
  };

  template <class Visit>
  static void for_each_pair(std::size_t count, Visit visit) {
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t j = i + 1; j < count; ++j)
        visit(i, j);
    }
  }
  template <std::size_t n, class PairOf>
  void add_term(const std::array<Index, n>& vertices, double scale,
                const std::array<Vec3, n>& gradient, PairOf pair_at) {
    for (std::size_t i = 0; i < n; ++i)
      add_own(vertices[i], scale, gradient[i]);
    std::size_t number = 0;
    for_each_pair(n, [&](std::size_t i, std::size_t j) {
      const std::size_t k = number++;
      if (!jacobian_.is_movable(vertices[i]) || !jacobian_.is_movable(vertices[j])) return;
      const auto [first, second] = vertices[i] < vertices[j] ? std::pair{i, j} : std::pair{j, i};
      add_product(vertices[first], pairs_[pair_at(k, i, j)], scale, gradient[second],
                  gradient[first]);
    });
  }

  /// Unknowns of a vertex: so many are moves, and those of inner ones have a multiplier after them.
  int moves(Index v) const { return v < inner_ ? moves_.inner : moves_.border; }
  int parts(Index v) const { return moves(v) + (v < inner_ ? 1 : 0); }
  int unknown(Index v, int part) const {
    const auto n = static_cast<int>(inner_), number = static_cast<int>(v);
    const int of_inner = moves_.inner + 1;
    return number < n ? of_inner * number + part
                      : of_inner * n + moves_.border * (number - n) + part;
  }
  int multiplier(Index v) const { return unknown(v, moves(v)); }
  Vec3 direction(Index v) const {
    return directions_[v < inner_ || moves_.inner == 1 ? v : v - inner_];
  }
  /// A vector's parts in the directions of the moves of a vertex.
  std::array<double, 3> along_moves(Index v, Vec3 a) const {
    if (moves(v) == 1) return {dot(direction(v), a)};
    return {a.x, a.y, a.z};
  }
  Vec3 move_of(Index v, const Eigen::VectorXd& solution) const;
  void for_all_pairs(const ForPairs& for_pairs, const SparseMatrix& square,
                     const std::function<void(Index, Index, bool)>& visit) const;
  void find_pairs(const ForPairs& for_pairs, const SparseMatrix& square);
  void lay_out();
  Pair pair_of(Index v, Index w) const;
  std::size_t start_of(Index first, const Entries& entries, std::size_t part) const;
  std::vector<Index> elimination_order(const PatchState& state) const;
  void add_product(Index first, const Entries& entries, double scale, Vec3 rows, Vec3 columns);
  void add_own(Index v, double scale, Vec3 gradient);
  void fill_jacobian();
  void fill_square(const SparseMatrix& square, double c);

  const AngleJacobian& jacobian_;
  Index inner_, count_;
  Moves moves_;
  std::vector<Vec3> directions_;
  double unit_ = 1.0;
  std::vector<std::size_t> pair_start_;                  // by first vertex
  std::vector<Entries> pairs_;                           // by first vertex, then by second
  std::vector<std::array<std::uint32_t, 4>> own_start_;  // of each vertex with itself, by column
  SparseMatrix lower_;
  std::optional<MixedLdlt> solver_;
};

}  // namespace planish
