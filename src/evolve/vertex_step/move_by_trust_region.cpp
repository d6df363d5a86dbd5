#include "evolve/vertex_step/move_by_trust_region.h"

#include <cmath>

#include "evolve/state/sweep.h"
#include "evolve/vertex_step/interval.h"
#include "evolve/vertex_step/minimise_on_line.h"
#include "evolve/vertex_step/ring_energy_on_line.h"

namespace planish {

namespace {

constexpr int k_most_halvings = 7;          // of a step that makes a needle
constexpr double k_start_in_bounds = 1e-3;  // of the interval, where 0 is its end

/// One vertex, its ring and what bounds its steps.
class Mover {
 public:
  Mover(const MoveOptions& options, const Site* sites, const Star& star, std::size_t valence)
      : options_(options), line_(sites, star, valence, options.max_cotangent) {
    const Site& origin =
        options.origins != nullptr ? options.origins[star.center] : sites[star.center];
    origin_ = {origin.x, origin.y, origin.z};
  }

  /// Moves the vertex if that lowers b.
  bool move(const Star& star, Site* sites, Changes changes) const {
    const LineSample before = line_.at(line_.start()).b;
    // Flat as far as numbers can tell: nothing to do.
    if (before.value <= line_.rounding_error(before.value)) return false;
    double lambda = best_step(before.slope);
    for (int halvings = 0; lambda != 0.0 && halvings <= k_most_halvings; ++halvings) {
      const Vec3 target = line_.place(lambda);
      const RingEnergyOnLine::Ring ring = line_.at(target);
      if (accepts(target, ring, before.value)) {
        line_.write(target, ring, star, sites, changes);
        return true;
      }
      // Steps of both signs can end in needles: then shorter ones are tried.
      if (!std::isfinite(options_.max_cotangent)) return false;
      lambda *= 0.5;
    }
    return false;
  }

 private:
  /// The step to the minimum that lies downhill; 0 where downhill is out of bounds.
  double best_step(double slope) const {
    const Interval steps = within_sphere({options_.lambda_min, options_.lambda_max}, line_.start(),
                                         line_.laplacian(), origin_, options_.radius);
    const double room = slope < 0.0 ? steps.high : slope > 0.0 ? -steps.low : 0.0;
    if (!(room > 0.0)) return 0.0;
    const bool inside = steps.low < 0.0 && steps.high > 0.0;
    const double start = inside ? 0.0 : std::copysign(k_start_in_bounds * room, -slope);
    const auto b = [this](double lambda) { return line_.at(line_.place(lambda)).b; };
    return minimise_on_line(b, steps, start).at;
  }

  /// The guarantee: what is compared is the energy at the very place that the vertex would get, and
  /// the fall must be more than rounding can feign.
  bool accepts(Vec3 target, const RingEnergyOnLine::Ring& ring, double before) const {
    const double after = ring.b.value;
    const Vec3 away = target - origin_;
    return ring.sound && target != line_.start() &&
           after + line_.rounding_error(after) < before - line_.rounding_error(before) &&
           !(dot(away, away) > options_.radius * options_.radius);
  }

  const MoveOptions& options_;
  RingEnergyOnLine line_;
  Vec3 origin_;
};

}  // namespace

void move_by_trust_region(const MoveOptions& options, Site* sites, Changes changes,
                          const Star* stars, std::size_t count, std::size_t valence,
                          unsigned char* moved) {
  for (std::size_t k = 0; k < count; ++k)
    moved[k] = Mover(options, sites, stars[k], valence).move(stars[k], sites, changes) ? 1 : 0;
}

}  // namespace planish
