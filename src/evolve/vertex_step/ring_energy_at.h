#pragma once

#include <span>
#include <vector>

#include <planish/core/vec.h>

#include "evolve/state/patch_state.h"

namespace planish {

/// The ring energy b_v of an inner vertex and its derivatives along a line through it.
struct StarSample {
  double value = 0.0;
  double slope = 0.0;      ///< of the value, exact
  double curvature = 0.0;  ///< of the value as Gauss and Newton have it: never negative
};

/// The ring energy of an inner vertex as a function of its place, all else staying. One arctangent
/// per angle: for those who move one vertex at a time and ask a few positions each.
class RingEnergyAt {
 public:
  /// @param defects of the inner vertices as the patch is now
  RingEnergyAt(const PatchState& state, Index center, std::span<const Index> ring,
               std::span<const double> defects);

  /// b_v with the centre at x.
  double value(Vec3 x) const;
  /// The same with derivatives along `direction`.
  StarSample along(Vec3 x, Vec3 direction) const;
  /// The defects with the centre at x: of each neighbour, 0 on the border, then of the centre.
  std::vector<double> defects(Vec3 x) const;
  /// True if a triangle at the centre would have no angles to speak of with the centre at x.
  bool has_needle(Vec3 x) const;

 private:
  struct Neighbour {
    Vec3 place;
    bool inner;
    double rest;  // 2 pi less the angles that the centre has no part in
  };
  /// The angles of the triangle of the centre, a neighbour and the one after it, in this order.
  struct Corners {
    double at_center, at_this, at_next;
  };

  std::size_t next(std::size_t j) const { return j + 1 < ring_.size() ? j + 1 : 0; }
  Corners corners(Vec3 x, std::size_t j) const;
  /// Calls body(defect) for the neighbours in their order, 0 on the border, then for the centre.
  template <class Body>
  void for_defects(Vec3 x, const Body& body) const;

  std::vector<Neighbour> ring_;
};

}  // namespace planish
