#pragma once

#include <span>
#include <vector>

#include "evolve/line_solver.h"
#include "evolve/patch_state.h"

namespace planish {

/// The ring energy b of one inner vertex: the sum of the squared defects that its place decides,
/// its own and those of its inner neighbours (Eq. 13, corrected). It holds every term of the energy
/// that changes when the vertex moves, so the energy falls exactly as it does.
///
/// With u_j = v_j - x and e_j = v_(j+1) - v_j, the triangle of x, v_j and v_(j+1) has the corners
///   at x        (u_j . u_(j+1),  S_j)
///   at v_j      (-u_j . e_j,     S_j)
///   at v_(j+1)  (u_(j+1) . e_j,  S_j)      with S_j = |u_j x u_(j+1)|, twice its area,
/// as complex numbers. Along a line x + lambda L all dot products and S_j^2 are quadratics in
/// lambda. Angles of the neighbours that x has no part in are constants.
///
/// Made to be used for one vertex after another; not to be shared between threads.
class RingEnergy {
 public:
  /// Turns to a vertex and evaluates its ring energy where it is.
  void look_at(const PatchState& state, std::size_t v);

  /// Where the vertex was when look_at() was called, its Laplacian vector with edge-length weights
  /// (Eq. 9), and its ring energy (sum of squares, radians).
  Vec3 start() const { return start_; }
  Vec3 laplacian() const;
  double energy() const { return energy_; }

  /// Sets the line x + lambda L for along().
  void set_line(Vec3 direction);
  /// b with its derivative (Eq. 15-17, corrected) and its Gauss-Newton curvature at lambda.
  LinePoint along(double lambda) const;

  /// Evaluates b at a place that need not be on the line, as it will be seen once the vertex is
  /// there: rounding included.
  double evaluate_at(Vec3 x);
  /// The largest error that rounding can have made in energy() or evaluate_at().
  double rounding_error() const { return rounding_error_; }
  /// False where x is a neighbour's place: an edge of length zero has no angles.
  bool keeps_lengths(Vec3 x) const;
  /// False where a triangle at x has an angle below `limit` (radians) and smaller than at start().
  bool keeps_angles(Vec3 x, double limit) const;

  /// Puts the vertex at x and the new defects into the state.
  /// @pre evaluate_at(x) was the last evaluation
  void move_to(Vec3 x, PatchState& state) const;

 private:
  struct Quadratic {
    double c0 = 0.0, c1 = 0.0, c2 = 0.0;
    double at(double t) const { return c0 + t * (c1 + t * c2); }
    double slope(double t) const { return c1 + 2.0 * t * c2; }
  };
  /// One neighbour v_j and the triangle after it.
  struct Spoke {
    Vec3 place, edge;     // v_j, e_j
    double rest = 0.0;    // 2 pi minus the angles at v_j that x has no part in
    double defect = 0.0;  // of v_j, at the last evaluation
    bool inner = false;
    Index vertex = 0;
    Quadratic apex, base, next_base, area_squared;  // the corners along the line; S_j^2
  };

  std::size_t vertex_ = 0;
  Vec3 start_;
  double energy_ = 0.0, own_defect_ = 0.0, rounding_error_ = 0.0;
  std::vector<Spoke> spokes_;
};

}  // namespace planish
