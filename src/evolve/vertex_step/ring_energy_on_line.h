#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include <planish/core/vec.h>

#include "core/simd/stars.h"
#include "evolve/simd/move_stars.h"
#include "evolve/vertex_step/minimise_on_line.h"

namespace planish {

/// The ring energy b of one inner vertex as it moves along its Laplacian vector, with exact
/// derivatives. What simd/ring_energy.h has for several vertices at once, without a model.
class RingEnergyOnLine {
 public:
  /// @param max_cotangent triangles whose angles are smaller than its may keep theirs
  RingEnergyOnLine(const Site* sites, const Star& star, std::size_t valence,
                   double max_cotangent = std::numeric_limits<double>::infinity());

  Vec3 start() const { return start_; }
  /// L(v) with edge-length weights (Eq. 9).
  Vec3 laplacian() const { return laplacian_; }
  /// x = v + lambda L, as it is stored.
  Vec3 place(double lambda) const { return start_ + lambda * laplacian_; }

  struct Ring {
    LineSample b;                 ///< by lambda; NaN where the vertex meets a neighbour
    double own = 0.0;             ///< defect of the vertex
    std::vector<double> defects;  ///< of the neighbours
    bool sound = true;            ///< no triangle got too small an angle
  };
  /// The ring with the vertex at x.
  Ring at(Vec3 x) const;

  /// The largest error that rounding can have made in a value of b.
  double rounding_error(double value) const;

  /// Puts the star at x, where the ring is as it was found there.
  void write(Vec3 x, const Ring& ring, const Star& star, Site* sites, Changes changes) const;

 private:
  /// A corner of a triangle as a complex number: its angle is the argument.
  struct Corner {
    double re, im;
  };
  /// What x decides of the triangle after a neighbour v_j.
  struct Base {
    Corner here, next;  ///< at v_j and v_(j+1); both have the doubled area as imaginary part
    Vec3 normal;        ///< N_j, as long as the doubled area
    double apex;        ///< real part of the corner at x
    double square, next_square;  ///< |u_j|^2, |u_(j+1)|^2
  };
  struct Spoke {
    Vec3 place, edge;  ///< v_j, e_j = v_(j+1) - v_j
    Vec3 normal_rate;  ///< of N_j
    double defect;     ///< of v_j at the start
    bool inner;
    Base start;            ///< of the triangle after v_j
    double max_cotangent;  ///< that this triangle may have
  };
  /// How an angle changed since the start and how fast it changes.
  struct Turn {
    double angle = 0.0, rate = 0.0, acceleration = 0.0;
    Turn& operator+=(const Turn& t) {
      angle += t.angle, rate += t.rate, acceleration += t.acceleration;
      return *this;
    }
  };

  std::size_t next(std::size_t j) const { return j + 1 < spokes_.size() ? j + 1 : 0; }
  Base base_at(std::size_t j, Vec3 x) const;
  static double largest_cotangent(const Base& base);
  static Turn turn_of(const Corner& then, const Corner& now, double cosine_rate, double size,
                      const Base& base, Vec3 normal_rate);

  Vec3 start_, laplacian_;
  double own_ = 0.0;
  std::vector<Spoke> spokes_;
};

}  // namespace planish
