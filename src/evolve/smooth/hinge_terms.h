#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "core/thread_pool.h"
#include "evolve/state/patch_state.h"

namespace planish {

/// The dihedral angles of a patch, signed, and their weights in the bending
/// sum w t^2, w = 3 l^2 / (A1 + A2) (Grinspun and others 2003; docs/fairness.md).
class HingeTerms {
 public:
  /// @param design any patch with the topology of the state, by its numbers
  /// @param state as it was at first; must outlive it
  HingeTerms(const Patch& design, const PatchState& state);

  std::size_t size() const { return hinges_.size(); }
  /// The ends of an inner edge, then the tips of its triangles, in the numbers of the state.
  const std::array<Index, 4>& corners(std::size_t hinge) const { return hinges_[hinge]; }

  /// Takes the weights from the patch as it is now.
  void take_weights(ThreadPool& pool);
  double weight(std::size_t hinge) const { return weights_[hinge]; }

  /// Sum of w (t - kept t0)^2 of the patch as it is now, with the weights as taken; t0 of the patch
  /// as it was when this was made.
  /// @param kept share of t0, 0 to 1: with 0 the bending
  double bending(ThreadPool& pool, double kept = 0.0) const;

  /// An angle, and its derivatives by the positions of the four corners.
  struct Slope {
    double angle = 0.0;
    std::array<Vec3, 4> gradient = {};
  };
  /// As the patch is now; zero where a triangle has no area.
  Slope slope(std::size_t hinge) const;
  /// t0 of bending().
  double first_angle(std::size_t hinge) const { return first_angles_[hinge]; }

 private:
  double angle(std::size_t hinge) const;

  const PatchState& state_;
  std::vector<std::array<Index, 4>> hinges_;
  std::vector<double> first_angles_, weights_;
};

}  // namespace planish
