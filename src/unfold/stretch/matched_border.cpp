#include "unfold/stretch/matched_border.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "core/math.h"
#include "optimize/line_search.h"
#include "unfold/disk/inner_system.h"
#include "unfold/stretch/flat_steps.h"
#include "unfold/stretch/seam_system.h"

namespace planish {

namespace {

/// Where the descent stands.
struct Place {
  std::vector<Vec2> flat;
  Eigen::VectorXd gaps;
  double energy = 0.0;

  /// What the line search makes smaller.
  double merit(double price) const { return energy + price * gaps.lpNorm<1>(); }
};

class Descent {
 public:
  Descent(const Disk& disk, const HeldBorder& border, std::vector<Vec2> start, ThreadPool& pool)
      : disk_(disk),
        system_(disk, border, pool),
        at_(place(turn_to_axis(disk, std::move(start)))) {}

  const Place& at() const { return at_; }
  bool all_kept() const { return system_.all_kept(at_.gaps); }

  /// The next step; nothing where there is none.
  std::optional<SeamSystem::Step> step() {
    for (const Curvature curvature : {Curvature::full, Curvature::projected}) {
      if (curvature == Curvature::full && !near_) continue;
      system_.assemble(at_.flat, curvature);
      factored_ = system_.factor();
      if (!factored_) continue;
      SeamSystem::Step step = system_.step();
      if (step.sound) return step;
    }
    return std::nullopt;
  }

  /// Goes along the step as far as the merit falls; false if it does not.
  bool follow(const SeamSystem::Step& step) {
    price_ = std::max(price_, 2.0 * step.largest_pull);
    const double slope = step.slope - price_ * at_.gaps.lpNorm<1>();
    const double merit = at_.merit(price_);
    Place found;
    const auto lowers = [&](double size, int) {
      const double wanted = merit + k_armijo * size * slope + 1e-15 * merit;
      found = place(moved(at_.flat, size, step.move));
      const bool straight = found.merit(price_) <= wanted;
      if (!std::isfinite(found.energy)) return straight;
      Place bent = corrected(found, (1.0 - size) * at_.gaps);
      if (!(bent.merit(price_) <= std::min(wanted, straight ? found.merit(price_) : wanted)))
        return straight;
      found = std::move(bent);
      return true;
    };
    const auto taken = backtrack(first_trial(disk_, at_.flat, step.move), k_most_trials, lowers);
    near_ = taken && taken->size == 1.0;
    if (!taken) return false;
    at_ = std::move(found);
    system_.follow(step.all, taken->size);
    return true;
  }

  /// Takes out of the lengths what is left to rounding, by the last factor, made near by. Without
  /// one, as before any step, nothing is done.
  void settle() {
    if (!factored_) return;
    const Eigen::VectorXd none = Eigen::VectorXd::Zero(at_.gaps.size());
    for (int round = 0; round < 4; ++round) {
      Place next = corrected(at_, none);
      const bool better = std::isfinite(next.energy) &&
                          next.gaps.lpNorm<Eigen::Infinity>() < at_.gaps.lpNorm<Eigen::Infinity>();
      if (!better) return;
      at_ = std::move(next);
    }
  }

 private:
  Place place(std::vector<Vec2> flat) const {
    const double energy = system_.energy(flat);
    Eigen::VectorXd gaps = system_.gaps(flat);
    return {std::move(flat), std::move(gaps), energy};
  }

  Place corrected(const Place& from, const Eigen::VectorXd& wanted_gaps) const {
    return place(moved(from.flat, 1.0, system_.correction(wanted_gaps - from.gaps)));
  }

  const Disk& disk_;
  SeamSystem system_;
  Place at_;
  double price_ = 0.0;
  bool near_ = false;      // the last step was taken whole: full curvature may serve
  bool factored_ = false;  // the system has a factor to solve with
};

/// Half the sum of the angles that chords span in a circle.
double half_turn(std::span<const double> chords, double diameter) {
  double sum = 0.0;
  for (const double chord : chords)
    sum += math::asin(std::min(1.0, chord / diameter));
  return sum;
}

/// The halves of the angles that the sides of an inscribed polygon span, in their order.
std::vector<double> inscribed_angles(std::span<const double> sides) {
  const auto longest = std::max_element(sides.begin(), sides.end());
  const double least = *longest;
  double total = 0.0;
  for (const double side : sides)
    total += side;
  // The centre is inside unless the other sides, with the longest for a diameter, span too little.
  const bool inside = half_turn(sides, least) >= std::numbers::pi;
  const auto excess = [&](double diameter) {
    const double all = half_turn(sides, diameter);
    if (inside) return all - std::numbers::pi;
    return 2.0 * math::asin(std::min(1.0, least / diameter)) - all;  // < 0 for large circles
  };
  double low = least, high = total;
  if (!inside) high = 1e8 * total;
  for (int k = 0; k < 200; ++k) {
    const double middle = std::sqrt(low) * std::sqrt(high);
    (excess(middle) > 0.0 ? low : high) = middle;
  }
  std::vector<double> angles;
  angles.reserve(sides.size());
  for (const double& side : sides) {
    const double angle = math::asin(std::min(1.0, side / low));
    angles.push_back(!inside && &side == &*longest ? std::numbers::pi - angle : angle);
  }
  return angles;
}

}  // namespace

std::vector<Vec2> circle_start(const Disk& disk, std::span<const double> lengths,
                               ThreadPool& pool) {
  const std::vector<double> angles = inscribed_angles(lengths);
  std::vector<Vec2> polygon;
  polygon.reserve(lengths.size());
  Vec2 at;
  double heading = 0.0;
  for (std::size_t k = 0; k < lengths.size(); ++k) {
    polygon.push_back(at);
    heading += angles[k];
    at = at + lengths[k] * Vec2{math::cos(heading), math::sin(heading)};
    heading += angles[k];
  }
  const std::vector<SideWeights> weights(disk.triangles.size(), SideWeights{1.0, 1.0, 1.0});
  return InnerSystem(disk, weights, pool).extend(disk, polygon);
}

MatchedBorder match_border(const Disk& disk, const HeldBorder& border, std::vector<Vec2> start,
                           int max_iterations, ThreadPool& pool,
                           const std::function<void()>& after_step) {
  // As for the pattern of least stretch.
  constexpr double no_energy = 4e-18, least_gain = 1e-6, least_fall = 1e-4;
  Descent descent(disk, border, std::move(start), pool);
  MatchedBorder matched;
  for (int& taken = matched.result.iterations; taken < max_iterations;) {
    const auto step = descent.step();
    if (!step) break;
    const double energy = descent.at().energy;
    const bool kept = descent.all_kept();
    const double gain = std::abs(step->slope);
    if (kept && (energy <= no_energy || gain <= least_gain * energy)) {
      matched.result.converged = true;
      break;
    }
    if (!descent.follow(*step)) {
      matched.result.converged = kept && gain <= least_fall * energy;
      break;
    }
    ++taken;
    if (after_step) after_step();
  }
  descent.settle();
  matched.matched = descent.all_kept() && all_upright(disk, descent.at().flat);
  matched.result.flat = descent.at().flat;
  return matched;
}

}  // namespace planish
