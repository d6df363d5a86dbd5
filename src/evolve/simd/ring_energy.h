// Included by one source file for each set of instructions.
#pragma once

#include "core/simd/arctangent.h"
#include "core/simd/stars.h"
#include "evolve/simd/line_search.h"
#include "evolve/simd/move_stars.h"

namespace planish::PLANISH_ISA {

/// b at one place.
struct RingValue {
  Real value;  ///< NaN where the vertex meets a neighbour
  Mask sound;  ///< no triangle got too small an angle
};

/// The spokes of a ring: as many as the valence says, on the stack where it is known at compile
/// time (Valence > 0).
template <class Spoke, int Valence>
class Spokes {
 public:
  explicit Spokes(int) {}
  Spoke& operator[](int j) { return spokes_[j]; }
  const Spoke& operator[](int j) const { return spokes_[j]; }

 private:
  Spoke spokes_[Valence];
};
template <class Spoke>
class Spokes<Spoke, 0> {
 public:
  explicit Spokes(int valence) : spokes_(new Spoke[static_cast<std::size_t>(valence)]) {}
  ~Spokes() { delete[] spokes_; }
  Spokes(const Spokes&) = delete;
  Spokes& operator=(const Spokes&) = delete;
  Spoke& operator[](int j) { return spokes_[j]; }
  const Spoke& operator[](int j) const { return spokes_[j]; }

 private:
  Spoke* spokes_;
};

/// The ring energy b of one inner vertex in each lane: the sum of the squared defects that its
/// place decides, its own and those of its inner neighbours (Eq. 13, corrected). It holds every
/// term of the energy that changes when the vertex moves, so the energy falls exactly as it does.
///
/// With u_j = v_j - x and e_j = v_(j+1) - v_j, the triangle of x, v_j and v_(j+1) has the corners
///   at v_j      (-u_j . e_j,     S_j)
///   at v_(j+1)  (u_(j+1) . e_j,  S_j)      with S_j = |N_j|, N_j = u_j x u_(j+1),
/// as complex numbers. The two corners at v_j multiply to P_j, whose argument is the part of the
/// angle sum of v_j that x has a hand in: the defect of v_j is what it was less the argument of
/// P_j conj(P_j before). As the angles of a triangle sum to pi, the defect of x is what it was plus
/// all these arguments, those at border neighbours included.
template <int Valence>
class RingEnergy {
 public:
  /// Looks at the rings of one star per lane.
  RingEnergy(const Site* sites, const Star* const* stars, int valence)
      : spokes_(valence), valence_(valence) {
    const double* rows[k_lanes];
    for (int lane = 0; lane < k_lanes; ++lane)
      rows[lane] = &sites[stars[lane]->center].x;
    const Columns own = load_columns(rows);
    start_ = {own.c0, own.c1, own.c2};
    own_before_ = own.c3;
    for (int j = 0; j < n(); ++j) {
      Spoke& spoke = spokes_[j];
      for (int lane = 0; lane < k_lanes; ++lane)
        rows[lane] = &sites[stars[lane]->ring[j]].x;
      const Columns neighbour = load_columns(rows);
      spoke.place = {neighbour.c0, neighbour.c1, neighbour.c2};
      spoke.inner = neighbour.c3 == neighbour.c3;  // the border's is NaN
      spoke.before = select(spoke.inner, neighbour.c3, Real{});
    }
    for (int j = 0; j < n(); ++j)
      spokes_[j].edge = spokes_[next(j)].place - spokes_[j].place;
  }

  Vector start() const { return start_; }

  /// L(v) with edge-length weights (Eq. 9).
  Vector laplacian() const {
    Vector sum{};
    Real weights{};
    for (int j = 0; j < n(); ++j) {
      const Vector u = spokes_[j].place - start_;
      const Real weight = square_root(dot(u, u));
      sum = sum + weight * u;
      weights += weight;
    }
    return select(weights > 0.0, 1.0 / weights, Real{}) * sum;
  }

  /// b near the start on the line x + lambda direction, from the angles' first three derivatives
  /// there; to be called first, as at() needs what it finds.
  /// @param max_cotangent triangles whose angles are smaller than its may keep theirs
  LineModel at_start(const Vector& direction, double max_cotangent) {
    guarded_ = max_cotangent < __builtin_inf();
    const Real speed_square = dot(direction, direction);
    for (int j = 0; j < n(); ++j) {
      Spoke& spoke = spokes_[j];
      spoke.u = spoke.place - start_;
      spoke.square = dot(spoke.u, spoke.u);
      spoke.inverse = 1.0 / spoke.square;
      spoke.turn = cross(spoke.u, direction);
      spoke.turn_square = dot(spoke.turn, spoke.turn);
      spoke.stretch = -dot(spoke.u, direction) * spoke.inverse;
      spoke.stretch_change = speed_square * spoke.inverse - 2.0 * spoke.stretch * spoke.stretch;
    }
    for (int j = 0; j < n(); ++j) {
      Spoke& spoke = spokes_[j];
      const Spoke& after = spokes_[next(j)];
      // From the edge and the shorter spoke, as then no angle of a needle loses digits.
      spoke.from_next = after.square < spoke.square;
      const Vector normal = find_triangle(j);
      if (guarded_) {
        const Real cotangent = largest_dot(j) / spoke.doubled_area;
        spoke.max_cotangent = max(broadcast(max_cotangent), cotangent);
      }
      find_angles(normal, spoke, after);
    }
    LineModel b{};
    Jet own{};
    for (int j = 0; j < n(); ++j) {
      Spoke& spoke = spokes_[j];
      spoke.corners_before = corners_of(j);
      spoke.defect = spoke.best = spoke.before;
      const Jet angle = spokes_[previous(j)].next_base_angle + spoke.base_angle;
      own = own + angle;
      const Real none{};
      b.add_square(-spoke.before, select(spoke.inner, angle.a1, none),
                   select(spoke.inner, angle.a2, none), select(spoke.inner, angle.a3, none));
    }
    b.add_square(own_before_, own.a1, own.a2, own.a3);
    own_best_ = own_before_;
    return b;
  }

  /// b with the vertices at x.
  RingValue at(const Vector& x) {
    for (int j = 0; j < n(); ++j)
      spokes_[j].u = spokes_[j].place - x;
    Mask narrow{};
    for (int j = 0; j < n(); ++j) {
      find_triangle(j);
      if (guarded_) narrow |= largest_dot(j) > spokes_[j].max_cotangent * spokes_[j].doubled_area;
    }
    RingValue b{};
    own_ = own_before_;
    for (int j = 0; j < n(); ++j) {
      Spoke& spoke = spokes_[j];
      const Real change = change_of(j);
      own_ += change;
      spoke.defect = spoke.before - select(spoke.inner, change, Real{});
      b.value += spoke.defect * spoke.defect;
    }
    b.value += own_ * own_;
    b.sound = (b.value == b.value) & ~narrow;
    return b;
  }

  /// Keeps the defects of the last evaluation where `better`.
  void keep(Mask better) {
    own_best_ = select(better, own_, own_best_);
    for (int j = 0; j < n(); ++j)
      spokes_[j].best = select(better, spokes_[j].defect, spokes_[j].best);
  }

  /// The largest error that rounding can have made in a value of b.
  Real rounding_error(const Real& value) const {
    // A few units in the last place of 2 pi for each defect, which goes through several updates in
    // a sweep: sum of 2 e |d| + e^2, at most 2 e sqrt((n + 1) b) + (n + 1) e^2.
    constexpr double e = 1e-14;
    const double count = n() + 1;
    return 2.0 * e * square_root(count * value) + count * (e * e);
  }

  /// Puts the star of a lane at x with the defects kept.
  void write(int lane, const Vector& x, const Star& star, Site* sites, Changes changes) const {
    sites[star.center] = {x.x[lane], x.y[lane], x.z[lane], own_best_[lane]};
    changes.changed_at[star.center] = changes.now;
    for (int j = 0; j < n(); ++j) {
      if (spokes_[j].inner[lane] == 0) continue;
      const std::uint32_t v = star.ring[j];
      sites[v].defect = spokes_[j].best[lane];
      changes.changed_at[v] = changes.now;
    }
  }

 private:
  /// Taylor coefficients of an angle on the line, from the first power on.
  struct Jet {
    Real a1, a2, a3;
    friend Jet operator+(const Jet& p, const Jet& q) {
      return {p.a1 + q.a1, p.a2 + q.a2, p.a3 + q.a3};
    }
  };

  /// One neighbour v_j and the triangle after it.
  struct Spoke {
    Vector place, edge;         // v_j, e_j
    Real before, defect, best;  // of v_j: at the start, at the last evaluation, kept
    Complex corners_before;     // P_j at the start
    Mask inner;
    Mask from_next;  // N_j is taken from u_(j+1), not u_j
    Real max_cotangent;
    // At the last evaluation:
    Vector u;
    Real doubled_area, base, next_base;  // S_j; real parts of the corners at v_j and v_(j+1)
    // At the start, along the line, where u' = -L:
    Vector turn;                      // K_j = u_j x L, which is constant
    Real square, inverse;             // |u_j|^2 and 1 / |u_j|^2
    Real turn_square;                 // |K_j|^2
    Real stretch, stretch_change;     // (log |u_j|)' and its derivative
    Jet base_angle, next_base_angle;  // the triangle's at v_j and v_(j+1)
  };

  int n() const { return Valence > 0 ? Valence : valence_; }
  int next(int j) const { return j + 1 < n() ? j + 1 : 0; }
  int previous(int j) const { return j > 0 ? j - 1 : n() - 1; }

  /// Finds the corners at the base of the triangle after v_j; returns N_j.
  Vector find_triangle(int j) {
    Spoke& spoke = spokes_[j];
    const Vector& u_next = spokes_[next(j)].u;
    const Vector normal = cross(select(spoke.from_next, u_next, spoke.u), spoke.edge);
    spoke.doubled_area = square_root(dot(normal, normal));
    spoke.base = -dot(spoke.u, spoke.edge);
    spoke.next_base = dot(u_next, spoke.edge);
    return normal;
  }

  Real largest_dot(int j) const {
    const Spoke& spoke = spokes_[j];
    return max(dot(spoke.u, spokes_[next(j)].u), max(spoke.base, spoke.next_base));
  }

  /// On the line the angles at the base change at the rates r = -(N . K_j) / (S |u_j|^2) at v_j and
  /// (N . K_(j+1)) / (S |u_(j+1)|^2) at v_(j+1). N changes by M = K_(j+1) - K_j while K does not,
  /// so the numerators A are linear; with g the logarithmic derivative of a denominator B, g = N .
  /// M / S^2 + 2 (log |u|)': r' = A' / B - g r and r'' = -2 g r' - (g^2 + g') r.
  static void find_angles(const Vector& normal, Spoke& spoke, const Spoke& after) {
    const Real s = spoke.doubled_area;
    const Real inverse = select(s > 0.0, 1.0 / s, Real{}), inverse_square = inverse * inverse;
    const Real along = dot(normal, spoke.turn), along_after = dot(normal, after.turn);
    const Real mixed = dot(spoke.turn, after.turn);
    const Real change = spoke.turn_square - mixed, change_after = after.turn_square - mixed;
    const Real growth = (along_after - along) * inverse_square;  // (log S)'
    const Real growth_change =
        (change + change_after) * inverse_square - 2.0 * growth * growth;  // |M|^2 / S^2 - ...
    const auto jet = [&](const Real& numerator, const Real& numerator_change, const Spoke& at) {
      const Real scale = inverse * at.inverse;
      const Real g = growth + 2.0 * at.stretch;
      const Real g_change = growth_change + 2.0 * at.stretch_change;
      const Real rate = numerator * scale, rate_change = numerator_change * scale - g * rate;
      return Jet{rate, 0.5 * rate_change,
                 (-1.0 / 6.0) * (2.0 * g * rate_change + (g * g + g_change) * rate)};
    };
    spoke.base_angle = jet(-along, change, spoke);
    spoke.next_base_angle = jet(along_after, change_after, after);
  }

  /// P_j.
  Complex corners_of(int j) const {
    const Spoke &after = spokes_[j], &before = spokes_[previous(j)];
    return Complex{before.next_base, before.doubled_area} * Complex{after.base, after.doubled_area};
  }

  /// How much the angle sum of v_j grew since the start.
  Real change_of(int j) const {
    const Spoke& spoke = spokes_[j];
    const Complex now = corners_of(j), then = spoke.corners_before;
    const Complex turn = now * Complex{then.re, -then.im};
    // A sum that passes the positive real axis has gone through 0 or 2 pi, which the turn hides.
    const Mask stays = (now.re < 0.0) | (now.im * then.im > 0.0);
    // Where edges are very short, the turn is too small a number, but now and then are not.
    const Mask near = is_short_and_exact(turn) & stays;
    const Real change = short_argument(turn);
    if (!any(~near)) return change;
    return select(near, change, full_angle(now) - full_angle(then));
  }

  /// The argument of a product of two corners from 0 to 2 pi. Where both are straight it is 2 pi,
  /// not 0: then the imaginary part is -0, the sum of a negative number times 0 and another.
  static Real full_angle(const Complex& z) {
    const Real angle = argument(z);
    const Mask straight = (z.re > 0.0) & (z.im == 0.0) & is_negative(z.im);
    return select((angle < 0.0) | straight, angle + 2.0 * k_pi, angle);
  }

  Real own_before_{}, own_{}, own_best_{};
  Vector start_{};
  Spokes<Spoke, Valence> spokes_;
  int valence_;
  bool guarded_ = false;
};

}  // namespace planish::PLANISH_ISA
