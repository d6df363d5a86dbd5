#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/thread_pool.h"
#include "evolve/descent/border_motion.h"
#include "evolve/smooth/hinge_terms.h"
#include "evolve/smooth/shape_guard.h"
#include "evolve/systems/angle_jacobian.h"
#include "evolve/systems/dense.h"
#include "evolve/systems/positions.h"
#include "solve/mixed_ldlt.h"

namespace planish {

/// A symmetric matrix of three rows.
struct Block {
  double xx = 0.0, xy = 0.0, xz = 0.0, yy = 0.0, yz = 0.0, zz = 0.0;
};

/// Which way inner vertices go in a step: in all directions, or each along one line.
enum class SmoothMoves { free, along_lines };

/// The steps dx of all vertices that may move, and multipliers y of the inner ones:
///
///     [ H   J^T     ] [dx]   [force]
///     [ J  -c K K^T ] [ y] = [dtheta]
///
/// H a sum of blocks between the corners of hinges, J = d d / d x the Jacobian of the defects, K
/// the matrix of StrainPotential. Quasi-definite, so factored without pivots, under a dissection of
/// the mesh: four unknowns to an inner vertex, two where it moves along a line; three to one of the
/// border that moves.
class SmoothSystem {
 public:
  /// @param square the lower half of K K^T; its pattern stays
  /// @param moves of inner vertices
  /// @param bends along the border, if that moves
  /// @param jacobian,hinges,guard must outlive it
  /// @throws Cancelled
  SmoothSystem(const AngleJacobian& jacobian, const PatchState& state, const HingeTerms& hinges,
               const ShapeGuard& guard, const SparseMatrix& square, SmoothMoves moves,
               const ThreadPool& pool, std::vector<BorderMotion::Bend> bends = {});

  /// Everything in H is zero.
  /// @param lines along which inner vertices move, of length 1; none where they move freely
  void clear(Positions lines = {});
  /// Adds s g g^T for the gradient of a hinge's angle, of an edge's length and of a corner's angle,
  /// by the number of the hinge, edge or corner.
  void add_hinge(std::size_t hinge, double scale, const std::array<Vec3, 4>& gradient);
  void add_edge(std::size_t edge, double scale, const std::array<Vec3, 2>& gradient);
  void add_corner(std::size_t corner, double scale, const std::array<Vec3, 3>& gradient);
  /// Adds s |w_a x_a + w_b x_b + w_c x_c|^2 / 2 for a bend, by its number.
  void add_bend(std::size_t bend, double scale);
  /// Adds a matrix to what a vertex has with itself.
  void add_vertex(Index v, const Block& block);

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
  /// Which pairs a term touches: those of its corners i < j in lexical order, diagonal included.
  using PairIndex = std::uint32_t;
  static constexpr PairIndex k_none = ~PairIndex{0};

  /// Two vertices that share entries of the matrix; the first has the lower number. Entries of one
  /// column follow one another among the values.
  struct Pair {
    Index second = 0;
    // Where they start in the columns of the first vertex: of its first move, see start_of(), and
    // of its multiplier.
    std::uint32_t first_start = k_none, multiplier_start = 0;

    /// Or only between multipliers.
    bool is_full() const { return first_start != k_none; }
  };
  /// Unknowns of a vertex: so many are moves, and those of inner ones have a multiplier after them.
  int moves(Index v) const { return v < inner_ ? inner_moves_ : 3; }
  int parts(Index v) const { return moves(v) + (v < inner_ ? 1 : 0); }
  int unknown(Index v, int part) const {
    const auto n = static_cast<int>(inner_), number = static_cast<int>(v);
    const int of_inner = inner_moves_ + 1;
    return number < n ? of_inner * number + part : of_inner * n + 3 * (number - n) + part;
  }
  int multiplier(Index v) const { return unknown(v, moves(v)); }
  /// A vector's parts in the directions of the moves of a vertex.
  std::array<double, 3> along_moves(Index v, Vec3 a) const {
    if (moves(v) == 1) return {dot(lines_[v], a)};
    return {a.x, a.y, a.z};
  }
  Vec3 move_of(Index v, const Eigen::VectorXd& solution) const;
  template <class Visit>
  void for_pairs_of_terms(const HingeTerms& hinges, const ShapeGuard& guard,
                          const SparseMatrix& square, Visit visit) const;
  void find_pairs(const HingeTerms& hinges, const ShapeGuard& guard, const SparseMatrix& square);
  void lay_out();
  void find_terms(const HingeTerms& hinges, const ShapeGuard& guard);
  PairIndex pair_of(Index v, Index w) const;
  std::size_t start_of(Index first, const Pair& pair, std::size_t part) const;
  std::vector<Index> elimination_order(const PatchState& state) const;
  void add_product(Index first, const Pair& pair, double scale, Vec3 rows, Vec3 columns);
  void add_own(Index v, double scale, Vec3 gradient);
  template <std::size_t n>
  void add_term(std::span<const PairIndex> pairs, const std::array<Index, n>& corners, double scale,
                const std::array<Vec3, n>& gradient);
  void add_rare_term(const std::array<Index, 3>& corners, double scale,
                     const std::array<Vec3, 3>& gradient);
  void fill_jacobian();
  void fill_square(const SparseMatrix& square, double c);

  const AngleJacobian& jacobian_;
  const HingeTerms& hinges_;
  const ShapeGuard& guard_;
  std::vector<BorderMotion::Bend> bends_;
  Index inner_, count_;
  int inner_moves_;                                      // of an inner vertex: 3, or 1
  Positions lines_;                                      // where it is 1
  std::vector<std::size_t> pair_start_;                  // by first vertex
  std::vector<Pair> pairs_;                              // by first vertex, then by second
  std::vector<std::array<std::uint32_t, 4>> own_start_;  // of each vertex with itself, by column
  std::vector<PairIndex> hinge_pairs_, edge_pairs_;
  SparseMatrix lower_;
  std::optional<MixedLdlt> solver_;
};

}  // namespace planish
