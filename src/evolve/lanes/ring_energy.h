// Included by one source file for each set of instructions.
#pragma once

#include "core/lanes/arctangent.h"
#include "core/lanes/stars.h"
#include "evolve/lanes/move_stars.h"

namespace planish::PLANISH_ISA {

/// b with its slope and Gauss-Newton curvature along a line, at one place of it.
struct LinePoint {
  Real value, slope, curvature;
  Mask sound;  ///< no neighbour's place, and no triangle got too small an angle
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
///   at x        (u_j . u_(j+1),  S_j)
///   at v_j      (-u_j . e_j,     S_j)
///   at v_(j+1)  (u_(j+1) . e_j,  S_j)      with S_j = |N_j|, N_j = u_j x u_(j+1),
/// as complex numbers. The two corners at v_j multiply to P_j, whose argument is the part of the
/// angle sum of v_j that x has a hand in: the defect of v_j is what it was less the argument of
/// P_j conj(P_j before). On a line along L the angles change by -(N_j . K_j) / (S_j |u_j|^2) at v_j
/// and (N_j . K_(j+1)) / (S_j |u_(j+1)|^2) at v_(j+1), with K_j = u_j x L, which is constant
/// there; the angle at x by minus both, as the three sum to pi.
template <int Valence>
class RingEnergy {
 public:
  /// Looks at the rings of one star per lane.
  RingEnergy(const Site* sites, std::size_t inner_count, const Star* const* stars, int valence)
      : spokes_(valence), valence_(valence) {
    const Bits inner_end = Bits{} + static_cast<std::int64_t>(inner_count);
    const double* rows[k_lanes];
    for (int lane = 0; lane < k_lanes; ++lane)
      rows[lane] = &sites[stars[lane]->center].x;
    const Columns own = load_columns(rows);
    start_ = {own.c0, own.c1, own.c2};
    own_before_ = own.c3;
    for (int j = 0; j < n(); ++j) {
      Spoke& spoke = spokes_[j];
      Bits number{};
      for (int lane = 0; lane < k_lanes; ++lane) {
        const std::uint32_t at = stars[lane]->ring[j];
        number[lane] = at;
        rows[lane] = &sites[at].x;
      }
      const Columns neighbour = load_columns(rows);
      spoke.place = {neighbour.c0, neighbour.c1, neighbour.c2};
      spoke.before = neighbour.c3;
      spoke.inner = number < inner_end;
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

  /// b where the vertices are, and what at() needs: to be called first.
  /// @param max_cotangent triangles whose angles are smaller than its may keep theirs
  LinePoint at_start(const Vector& direction, double max_cotangent) {
    guarded_ = max_cotangent < __builtin_inf();
    for (int j = 0; j < n(); ++j) {
      spokes_[j].turn = cross(spokes_[j].place - start_, direction);
      spokes_[j].max_cotangent = all(max_cotangent);
    }
    corners_at(start_);
    LinePoint b = begin_with(own_before_);
    for (int j = 0; j < n(); ++j) {
      Spoke& spoke = spokes_[j];
      if (guarded_) {
        spoke.max_cotangent = greatest(all(max_cotangent), spoke.largest_dot / spoke.doubled_area);
      }
      spoke.corners_before = corners_of_neighbour(j);
      const Real shrink = exponent_off(
          greatest(absolute(spoke.corners_before.re), absolute(spoke.corners_before.im)));
      spoke.corners_before.re *= shrink;
      spoke.corners_before.im *= shrink;
      spoke.straight_before = straight_at_neighbour(j);
      spoke.before = select(spoke.inner, spoke.before, Real{});
      spoke.defect = spoke.best = spoke.before;
      add(b, spoke.before, select(spoke.inner, rate_at_neighbour(j), Real{}));
    }
    own_best_ = own_before_;
    return finished(b);
  }

  /// b with the vertices at x.
  LinePoint at(const Vector& x) {
    corners_at(x);
    own_ = own_angles_.defect();
    LinePoint b = begin_with(own_);
    b.sound = sound_;
    for (int j = 0; j < n(); ++j) {
      Spoke& spoke = spokes_[j];
      spoke.defect = spoke.before - select(spoke.inner, change_at_neighbour(j), Real{});
      add(b, spoke.defect, select(spoke.inner, rate_at_neighbour(j), Real{}));
    }
    return finished(b);
  }

  /// Keeps the defects of the last evaluation where `better`.
  void keep(Mask better) {
    own_best_ = select(better, own_, own_best_);
    for (int j = 0; j < n(); ++j)
      spokes_[j].best = select(better, spokes_[j].defect, spokes_[j].best);
  }

  /// The largest error that rounding can have made in b with the defects kept.
  Real rounding_error() const {
    // A few units in the last place of 2 pi for a neighbour, whose defect went through several
    // updates in a sweep; one per corner for the vertex itself.
    constexpr double neighbour_error = 1e-14;
    const double own_error = 1e-15 * (n() + 4);
    Real error = own_error * (2.0 * absolute(own_best_) + own_error);
    for (int j = 0; j < n(); ++j) {
      const Spoke& spoke = spokes_[j];
      const Real term = neighbour_error * (2.0 * absolute(spoke.best) + neighbour_error);
      error += select(spoke.inner, term, Real{});
    }
    return error;
  }

  /// Puts the star of a lane at x with the defects kept.
  void write(int lane, const Vector& x, const Star& star, Site* sites) const {
    sites[star.center] = {x.x[lane], x.y[lane], x.z[lane], own_best_[lane]};
    for (int j = 0; j < n(); ++j) {
      if (spokes_[j].inner[lane] != 0) sites[star.ring[j]].defect = spokes_[j].best[lane];
    }
  }

 private:
  /// One neighbour v_j and the triangle after it.
  struct Spoke {
    Vector place, edge, turn;     // v_j, e_j, K_j
    Real before, defect, best;    // of v_j: at the start, at the last evaluation, kept
    Complex corners_before;       // P_j at the start
    Mask inner, straight_before;  // straight: both corners were pi
    Real max_cotangent;
    // Of the triangle, at the last evaluation:
    Real doubled_area, base, next_base;  // S_j; real parts of the corners at v_j and v_(j+1)
    Real base_rate, next_base_rate;      // change of the angles there along the line
    Real largest_dot;
  };

  int n() const { return Valence > 0 ? Valence : valence_; }
  int next(int j) const { return j + 1 < n() ? j + 1 : 0; }
  int previous(int j) const { return j > 0 ? j - 1 : n() - 1; }

  /// Half of slope and curvature.
  static void add(LinePoint& b, const Real& defect, const Real& rate) {
    b.value += defect * defect;
    b.slope -= defect * rate;
    b.curvature += rate * rate;
  }

  static LinePoint finished(LinePoint b) {
    b.slope *= 2.0;
    b.curvature *= 2.0;
    return b;
  }

  LinePoint begin_with(const Real& own_defect) const {
    LinePoint b{};
    add(b, own_defect, own_rate_);
    return b;
  }

  /// All that follows from x alone.
  void corners_at(const Vector& x) {
    own_angles_ = {};
    own_rate_ = Real{};
    Vector u = spokes_[0].place - x;
    Real length = dot(u, u);
    sound_ = length > 0.0;
    for (int j = 0; j < n(); ++j) {
      Spoke& spoke = spokes_[j];
      const Vector u_next = spokes_[next(j)].place - x;
      const Real length_next = dot(u_next, u_next);
      // From the edge and the shorter spoke, as then no angle of a needle loses digits.
      const Vector normal = cross(select(length < length_next, u, u_next), spoke.edge);
      const Real s = square_root(dot(normal, normal)), apex = dot(u, u_next);
      spoke.doubled_area = s;
      spoke.base = -dot(u, spoke.edge);
      spoke.next_base = dot(u_next, spoke.edge);
      const Real sizes = s * length * length_next;
      const Real inverse = select(sizes > 0.0, 1.0 / sizes, Real{});
      spoke.base_rate = -dot(normal, spoke.turn) * (inverse * length_next);
      spoke.next_base_rate = dot(normal, spokes_[next(j)].turn) * (inverse * length);
      own_rate_ -= spoke.base_rate + spoke.next_base_rate;
      own_angles_.add({apex, s});
      sound_ &= length_next > 0.0;
      if (guarded_) {
        spoke.largest_dot = greatest(apex, greatest(spoke.base, spoke.next_base));
        sound_ &= ~(spoke.largest_dot > spoke.max_cotangent * s);
      }
      u = u_next;
      length = length_next;
    }
  }

  Real rate_at_neighbour(int j) const {
    return spokes_[previous(j)].next_base_rate + spokes_[j].base_rate;
  }

  /// P_j at the last evaluation.
  Complex corners_of_neighbour(int j) const {
    const Spoke &after = spokes_[j], &before = spokes_[previous(j)];
    return Complex{before.next_base, before.doubled_area} * Complex{after.base, after.doubled_area};
  }

  /// How much the angle sum of v_j grew since the start.
  Real change_at_neighbour(int j) const {
    const Spoke& spoke = spokes_[j];
    const Complex now = corners_of_neighbour(j), before = spoke.corners_before;
    const Complex turn = now * Complex{before.re, -before.im};
    // A sum that passes the positive real axis has gone through 0 or 2 pi, which the turn hides.
    const Mask stays = (now.re < 0.0) | (now.im * before.im > 0.0);
    const Mask near = (is_short(turn) & stays) | ~spoke.inner;
    const Real change = short_argument(turn);
    if (!any(~near)) return change;
    const Real whole =
        full_angle(now, straight_at_neighbour(j)) - full_angle(before, spoke.straight_before);
    return select(near, change, whole);
  }

  Mask straight_at_neighbour(int j) const {
    return (spokes_[j].doubled_area == 0.0) & (spokes_[previous(j)].doubled_area == 0.0) &
           (spokes_[j].base < 0.0) & (spokes_[previous(j)].next_base < 0.0);
  }

  /// The argument of two corners' product from 0 to 2 pi, which it is where both are straight.
  static Real full_angle(const Complex& z, Mask straight) {
    const Real angle = argument(z);
    return select((angle < 0.0) | straight, angle + 2.0 * k_pi, angle);
  }

  Real own_before_{}, own_{}, own_best_{}, own_rate_{};
  Mask sound_{};
  Vector start_{};
  AngleSum own_angles_;
  Spokes<Spoke, Valence> spokes_;
  int valence_;
  bool guarded_ = false;
};

}  // namespace planish::PLANISH_ISA
