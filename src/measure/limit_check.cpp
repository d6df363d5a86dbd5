#include <algorithm>
#include <cstddef>
#include <string>

#include <planish/core/error.h>
#include <planish/core/range.h>
#include <planish/measure/limit_check.h>

namespace planish {

namespace {

constexpr std::array<std::string_view, 21> k_names = {"strain",
                                                      "p99_strain",
                                                      "rms_strain",
                                                      "stretch",
                                                      "p99_stretch",
                                                      "compression",
                                                      "p99_compression",
                                                      "deviation",
                                                      "angle",
                                                      "e_max",
                                                      "bending",
                                                      "rejected",
                                                      "failure",
                                                      "size",
                                                      "stretched",
                                                      "crumpled",
                                                      "form",
                                                      "fold",
                                                      "self_intersections",
                                                      "overlap",
                                                      "flipped_triangles"};

/// What a limit of strain bounds.
struct BoundedFigure {
  std::string_view name, words;
  double StrainLimits::*limit;
  double EdgeStrain::*figure;
};

constexpr std::array<BoundedFigure, k_strain_criteria.size()> k_figures = {
    {{"max", "strain of every edge", &StrainLimits::max, &EdgeStrain::max},
     {"p99", "strain on 99 % of the area", &StrainLimits::p99, &EdgeStrain::p99},
     {"rms", "rms strain", &StrainLimits::rms, &EdgeStrain::rms},
     {"max_stretch", "stretch of every edge", &StrainLimits::max_stretch, &EdgeStrain::max_stretch},
     {"p99_stretch", "stretch on 99 % of the area", &StrainLimits::p99_stretch,
      &EdgeStrain::p99_stretch},
     {"max_compression", "compression of every edge", &StrainLimits::max_compression,
      &EdgeStrain::max_compression},
     {"p99_compression", "compression on 99 % of the area", &StrainLimits::p99_compression,
      &EdgeStrain::p99_compression}}};

const BoundedFigure& bounded(Criterion what) {
  return k_figures.at(static_cast<std::size_t>(what));
}

/// The smaller of limits, 0 where there is none.
double smaller(double a, double b) {
  if (a == 0.0 || b == 0.0) return std::max(a, b);
  return std::min(a, b);
}

/// Half of the way between a limit of stretch and one of compression; 0 where one is free.
double mean_of(double stretch, double compression) {
  if (stretch == 0.0 || compression == 0.0) return 0.0;
  return stretch == compression ? stretch : 0.5 * (stretch + compression);
}

}  // namespace

std::string_view to_string(Criterion criterion) {
  return k_names.at(static_cast<std::size_t>(criterion));
}

std::string_view figure_name(Criterion what) {
  return bounded(what).name;
}

double figure_of(const EdgeStrain& strain, Criterion what) {
  return strain.*bounded(what).figure;
}

double& StrainLimits::of(Criterion what) {
  return this->*bounded(what).limit;
}

double StrainLimits::of(Criterion what) const {
  return this->*bounded(what).limit;
}

bool StrainLimits::any() const {
  return rms > 0.0 || bounds_edges();
}

bool StrainLimits::bounds_edges() const {
  return std::any_of(k_strain_criteria.begin(), k_strain_criteria.end(), [this](Criterion what) {
    return what != Criterion::rms_strain && of(what) > 0.0;
  });
}

double StrainLimits::both_ways() const {
  const double of_area = mean_of(smaller(p99, p99_stretch), smaller(p99, p99_compression));
  if (of_area > 0.0) return of_area;
  return mean_of(smaller(max, max_stretch), smaller(max, max_compression));
}

bool StrainLimits::kept_by(const EdgeStrain& strain) const {
  return all_kept(check_limits(strain, *this));
}

void require(const StrainLimits& limits) {
  constexpr Range range = {0.0, k_largest_strain_limit};
  for (const Criterion what : k_strain_criteria)
    check_range("the limit of " + std::string(bounded(what).words), limits.of(what), range);
}

std::vector<LimitCheck> check_limits(const EdgeStrain& strain, const StrainLimits& limits) {
  std::vector<LimitCheck> checks;
  for (const Criterion what : k_strain_criteria) {
    const double limit = limits.of(what);
    if (limit != 0.0) checks.push_back({what, limit, figure_of(strain, what)});
  }
  return checks;
}

bool all_kept(std::span<const LimitCheck> checks) {
  return std::all_of(checks.begin(), checks.end(),
                     [](const LimitCheck& check) { return check.met; });
}

}  // namespace planish
