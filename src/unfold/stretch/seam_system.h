#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "unfold/stretch/held_border.h"
#include "unfold/stretch/stretch_system.h"

namespace planish {

/// The Newton steps of a flat disk whose border edges are to have given lengths, and whose border
/// bends at a cost (TurnBending):
///
///     [ H  J^T  ] [ move ]   [     -g     ]
///     [ J  -d I ] [ pull ] = [ -gap - d y ]
///
/// g and H gradient and Hessian of both energies plus y times the lengths, J the derivative of the
/// lengths, y the pulls of the edges before, d so small that it only keeps pivots away from 0. A
/// border edge is eliminated right after its ends, so that its pivot is far from 0 already. The row
/// of an edge that is free is -1 on the diagonal alone, so that its pull is 0.
class SeamSystem final : public StretchSystem {
 public:
  /// @param border must outlive it, as must the disk and the pool
  SeamSystem(const Disk& disk, const HeldBorder& border, ThreadPool& pool);

  void stiffen(double factor) override { stiffness_ = factor; }
  double energy(const std::vector<Vec2>& flat) const override {
    return StretchSystem::energy(flat) + stiffness_ * border_.bend.value(flat);
  }
  void assemble(const std::vector<Vec2>& flat, Curvature curvature) override;
  /// False also where the energy has no minimum among moves that keep lengths, which happens with
  /// full curvature only.
  bool factor() override;
  /// Takes lengths that are not kept for changed by as much.
  Eigen::VectorXd right() const override;
  /// With the lengths kept (all_kept()).
  std::optional<std::vector<Vec2>> restored(std::vector<Vec2> flat) const override;
  /// Takes over the pulls.
  void follow(const Eigen::VectorXd& step, double share) override;

  /// Length less wanted length of each border edge; 0 of those that are free.
  Eigen::VectorXd gaps(const std::vector<Vec2>& flat) const;
  /// Whether no length is off by more than 1e-10 of it, or by what rounding makes of coordinates
  /// near 1.
  bool all_kept(const Eigen::VectorXd& gaps) const;

  struct Step {
    Eigen::VectorXd all;  ///< of all unknowns
    std::vector<Vec2> move;
    double largest_pull = 0.0;
    double slope = 0.0;  ///< of the energy along the move
    bool sound = false;  ///< it does solve the system
  };
  /// @pre factor() was true
  Step step() const;
  /// The least move, in the energy's measure, that changes lengths by as much.
  std::vector<Vec2> correction(const Eigen::VectorXd& change) const;

 private:
  Hessian6 hessian_of(std::size_t t, const TriangleEnergy& energy, const std::vector<Vec2>& flat,
                      Curvature curvature) const override;
  std::vector<Index> elimination_order() const override;
  Index block_of_pull(std::size_t k) const { return static_cast<Index>(disk_.vertex_count + k); }
  int row_of_pull(std::size_t k) const { return matrix_.unknown(block_of_pull(k), 0); }
  void find_edges_of_triangles();
  void add_lengths(const std::vector<Vec2>& flat);

  const HeldBorder& border_;
  std::vector<std::vector<Index>> edges_of_;  // border edges of each triangle that has some
  std::vector<TrianglePairs> turn_pairs_;
  Eigen::VectorXd pulls_, gaps_;
  double stiffness_ = 1.0;  // of the border's bend
};

/// A system of the disk, whose border is free where none is held.
/// @param border nullptr or outlives it
std::unique_ptr<StretchSystem> make_system(const Disk& disk, const HeldBorder* border,
                                           ThreadPool& pool);

}  // namespace planish
