// Included by one source file for each set of instructions.
#pragma once

#include "evolve/simd/line_search.h"
#include "evolve/simd/ring_energy.h"

namespace planish::PLANISH_ISA {

struct Steps {
  Real low, high;
};

/// The steps from x along `direction` that end within `radius` of origin; always holds 0.
inline Steps within_sphere(const MoveOptions& options, const Vector& offset,
                           const Vector& direction) {
  // A hair inside, so that rounding cannot carry a vertex out: |x + t L - o|^2 = r^2.
  const double r = options.radius * (1.0 - 1e-12);
  const Real a = dot(direction, direction), b = dot(offset, direction);
  const Real c = dot(offset, offset) - r * r;
  const Real discriminant = b * b - a * c;
  const Mask meets = (discriminant > 0.0) & (a > 0.0);
  // The root of larger size first, the other from it, without cancellation.
  const Real root = square_root(select(meets, discriminant, Real{}));
  const Real q = -(b + select(b < 0.0, -root, root));
  const Real t1 = select(meets, q / a, Real{}), t2 = select(meets & (q != 0.0), c / q, Real{});
  const Real low = min(t1, t2), high = max(t1, t2);
  return {min(max(low, broadcast(options.lambda_min)), Real{}),
          max(min(high, broadcast(options.lambda_max)), Real{})};
}

/// One star in each lane, of which the first `used` count; the others repeat the first.
template <int Valence>
[[gnu::flatten]] void move_some(const MoveOptions& options, Site* sites, Changes changes,
                                const Star* const* stars, int used, int valence,
                                unsigned char* moved) {
  RingEnergy<Valence> ring(sites, stars, valence);
  const Vector start = ring.start(), laplacian = ring.laplacian();
  const LineModel model = ring.at_start(laplacian, options.max_cotangent);
  const Real before = model.c[0], error = ring.rounding_error(before);
  const bool bounded = options.radius < __builtin_inf();
  Vector offset{};
  Steps steps{broadcast(options.lambda_min), broadcast(options.lambda_max)};
  if (bounded) {
    Vector origin{};
    for (int lane = 0; lane < k_lanes; ++lane) {
      const Site& site = options.origins[stars[lane]->center];
      origin.x[lane] = site.x, origin.y[lane] = site.y, origin.z[lane] = site.z;
    }
    offset = start - origin;
    steps = within_sphere(options, offset, laplacian);
  }

  // Flat as far as numbers can tell: nothing to do.
  LineSearch search(model, steps.low, steps.high, before <= error);
  Mask sound{};
  for (int i = 1; i < LineSearch::k_most_evaluations; ++i) {
    const Real lambda = search.next();
    if (search.done()) break;
    const RingValue point = ring.at(start + lambda * laplacian);
    const Mask better = search.tell(lambda, point.value);
    ring.keep(better);
    sound = (better & point.sound) | (~better & sound);
  }

  // The guarantee: what is compared is the energy at the very place that the vertex would get, and
  // the fall must be more than rounding can feign.
  Real lambda = search.at(), value = search.value();
  const auto accepted = [&] {
    const Vector target = start + lambda * laplacian;
    const Mask same = (target.x == start.x) & (target.y == start.y) & (target.z == start.z);
    Mask accept = sound & ~same & (value + ring.rounding_error(value) < before - error);
    if (bounded) {
      const Vector away = offset + (target - start);
      accept &= dot(away, away) <= options.radius * options.radius;
    }
    return accept;
  };
  Mask accept = accepted();
  // Steps of both signs can end in needles: then shorter ones are tried.
  const bool guarded = options.max_cotangent < __builtin_inf();
  for (int tries = 1; guarded && tries < 8; ++tries) {
    const Mask again = ~accept & (lambda != 0.0);
    if (!any(again)) break;
    lambda = select(again, 0.5 * lambda, lambda);
    const RingValue point = ring.at(start + lambda * laplacian);
    ring.keep(again);
    value = select(again, point.value, value);
    sound = (again & point.sound) | (~again & sound);
    accept |= again & accepted();
  }
  const Vector target = start + lambda * laplacian;
  for (int lane = 0; lane < used; ++lane) {
    moved[lane] = accept[lane] != 0 ? 1 : 0;
    if (moved[lane] != 0) ring.write(lane, target, *stars[lane], sites, changes);
  }
}

template <int Valence>
void move_stars(const MoveOptions& options, Site* sites, Changes changes, const Star* stars,
                std::size_t count, int valence, unsigned char* moved) {
  for (std::size_t begin = 0; begin < count; begin += k_lanes) {
    const int used = count - begin < k_lanes ? static_cast<int>(count - begin) : k_lanes;
    const Star* in_lane[k_lanes];
    for (int lane = 0; lane < k_lanes; ++lane)
      in_lane[lane] = stars + begin + (lane < used ? lane : 0);
    move_some<Valence>(options, sites, changes, in_lane, used, valence, moved + begin);
  }
}

inline void move_stars(const MoveOptions& options, Site* sites, Changes changes, const Star* stars,
                       std::size_t count, std::size_t valence, unsigned char* moved) {
  const int n = static_cast<int>(valence);
  const auto with = [&](auto move) { move(options, sites, changes, stars, count, n, moved); };
  switch (n) {
    case 3:
      return with(move_stars<3>);
    case 4:
      return with(move_stars<4>);
    case 5:
      return with(move_stars<5>);
    case 6:
      return with(move_stars<6>);
    case 7:
      return with(move_stars<7>);
    case 8:
      return with(move_stars<8>);
    case 9:
      return with(move_stars<9>);
    case 10:
      return with(move_stars<10>);
    case 11:
      return with(move_stars<11>);
    case 12:
      return with(move_stars<12>);
    default:
      return with(move_stars<0>);
  }
}

}  // namespace planish::PLANISH_ISA
