#include "unfold/stretch/spread_stretch.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "energy/strain_price.h"
#include "optimize/line_search.h"
#include "unfold/strain/strain_of_edges.h"
#include "unfold/stretch/flat_steps.h"

namespace planish {

namespace {

/// How fast a border that is held gets stiffer with the weight of the price: else it would get
/// teeth where the price alone counts. Thrice as fast, peaks fall by some 2 % less; a third as
/// fast, the border turns to and fro two or three times as much.
constexpr double k_stiffening = 0.1;

/// The strain that edges of 99 % of the area do not exceed.
double peak_strain(std::span<const FlatEdge> edges, std::span<const double> strains) {
  constexpr double share = 0.99;
  return strain_at_share(with_areas(edges, strains), share);
}

/// Newton steps that lower E + w E_0 P, E the symmetric Dirichlet energy, E_0 that of the start, P
/// the StrainPrice.
class PricedSteps {
 public:
  PricedSteps(const Disk& disk, StretchSystem& system, const std::vector<Vec2>& start,
              const StrainPrice& price)
      : disk_(disk), system_(system), price_(price), flat_(start), unit_(system.energy(start)) {
    ends_.reserve(price.edges.size());
    for (const FlatEdge& edge : price.edges)
      ends_.push_back(system_.pair_of(edge));
  }

  /// False where no step lowers the energy of that weight.
  bool step(double weight) {
    const double price = weight * unit_;
    system_.stiffen(1.0 + k_stiffening * weight);
    assemble(price);
    if (!system_.factor()) return false;
    const Eigen::VectorXd step = system_.solve(system_.right());
    const double slope = system_.gradient().dot(step);
    if (!(slope < 0.0)) return false;
    return move_along(step, slope, price);
  }

  const std::vector<Vec2>& flat() const { return flat_; }

 private:
  void assemble(double price) {
    system_.assemble(flat_, Curvature::projected);
    for (std::size_t e = 0; e < ends_.size(); ++e) {
      const FlatEdge& edge = price_.edges[e];
      system_.add(edge, ends_[e], price_.term(edge, flat_, price));
    }
  }

  double energy(const std::vector<Vec2>& flat, double price) const {
    return system_.energy(flat) + price * price_.value(flat);
  }

  bool move_along(const Eigen::VectorXd& step, double slope, double price) {
    constexpr int most_trials = 30;
    const std::vector<Vec2> move = system_.spread(step);
    const double now = energy(flat_, price);
    const auto lowers = [&](double size, int) {
      auto trial = system_.restored(moved(flat_, size, move));
      if (!trial || !(energy(*trial, price) <= now + k_armijo * size * slope)) return false;
      flat_ = *std::move(trial);
      system_.follow(step, size);
      return true;
    };
    return backtrack(first_trial(disk_, flat_, move), most_trials, lowers).has_value();
  }

  const Disk& disk_;
  StretchSystem& system_;
  StrainPrice price_;
  std::vector<BlockMatrix::Pair> ends_;
  std::vector<Vec2> flat_;
  double unit_;
};

/// What a pattern must keep while its stretch moves.
class Budget {
 public:
  Budget(const Disk& disk, std::span<const FlatEdge> edges, const std::vector<Vec2>& least,
         double most_rms)
      : disk_(disk),
        edges_(edges),
        most_rms_(most_rms),
        may_cross_(border_crosses_itself(disk, least)) {}

  bool keeps(const std::vector<Vec2>& flat) const {
    return all_upright(disk_, flat) && rms_strain(edges_, strains_of(edges_, flat)) <= most_rms_ &&
           (may_cross_ || !border_crosses_itself(disk_, flat));
  }

  /// The last place on the way from one that keeps it to one that does not.
  std::vector<Vec2> last_kept(const StretchSystem& system, std::vector<Vec2> kept,
                              const std::vector<Vec2>& beyond) const {
    constexpr int halvings = 10;
    std::vector<Vec2> way(kept.size());
    for (std::size_t v = 0; v < way.size(); ++v)
      way[v] = beyond[v] - kept[v];
    double part = 0.5;
    for (int k = 0; k < halvings; ++k, part *= 0.5) {
      auto trial = system.restored(moved(kept, part, way));
      if (trial && keeps(*trial)) kept = *std::move(trial);
    }
    return kept;
  }

 private:
  const Disk& disk_;
  std::span<const FlatEdge> edges_;
  double most_rms_;
  bool may_cross_;
};

}  // namespace

LeastStretch spread_stretch(const Disk& disk, StretchSystem& system,
                            std::span<const FlatEdge> edges, LeastStretch least, double most_rms,
                            const std::function<void()>& after_step) {
  // Sheet steel takes that, the stiffest material that is known: there is nothing to be gained.
  constexpr double any_sheet_takes = 2e-3;
  // Each weight is led to by one step: from so little that nothing moves to so much that the price
  // alone counts.
  constexpr int most_weights = 12;
  constexpr double first_weight = 0.1, growth = 4.0;
  const double peak = peak_strain(edges, strains_of(edges, least.flat));
  if (!(peak > any_sheet_takes)) return least;
  const Budget budget(disk, edges, least.flat, most_rms);
  PricedSteps spreading(disk, system, least.flat, {edges, peak, peak_price});
  LeastStretch result{least.flat, least.iterations, least.converged};
  double weight = first_weight;
  for (int k = 0; k < most_weights; ++k, weight *= growth) {
    if (!spreading.step(weight)) break;
    ++result.iterations;
    if (after_step) after_step();
    if (!budget.keeps(spreading.flat())) {
      result.flat = budget.last_kept(system, std::move(result.flat), spreading.flat());
      break;
    }
    result.flat = spreading.flat();
  }
  if (!(peak_strain(edges, strains_of(edges, result.flat)) < peak)) return least;
  return result;
}

LeastStretch lower_rms(const Disk& disk, StretchSystem& system, std::span<const FlatEdge> edges,
                       LeastStretch least, double most_rms,
                       const std::function<void()>& after_step) {
  // From where the energy counts as much to where less than 0.1 % of the rms is left to gain.
  constexpr int most_weights = 5;
  constexpr double first_weight = 0.1, growth = 4.0;
  const auto rms_of = [&](const std::vector<Vec2>& flat) {
    return rms_strain(edges, strains_of(edges, flat));
  };
  const double least_rms = rms_of(least.flat);
  const Budget budget(disk, edges, least.flat, least_rms);
  PricedSteps lowering(disk, system, least.flat, {edges, least_rms, square_price});
  LeastStretch result = std::move(least);
  double weight = first_weight;
  for (int k = 0; k < most_weights && rms_of(result.flat) > most_rms; ++k, weight *= growth) {
    if (!lowering.step(weight)) break;
    if (after_step) after_step();
    if (!budget.keeps(lowering.flat())) break;
    ++result.iterations;
    result.flat = lowering.flat();
  }
  return result;
}

double rms_strain(std::span<const FlatEdge> edges, std::span<const double> strains) {
  NeumaierSum squares, area;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    squares.add(edges[e].area * strains[e] * strains[e]);
    area.add(edges[e].area);
  }
  return area.value() > 0.0 ? std::sqrt(squares.value() / area.value()) : 0.0;
}

}  // namespace planish
