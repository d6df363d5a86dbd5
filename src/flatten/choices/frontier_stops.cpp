#include <algorithm>

#include <planish/flatten/frontier.h>

#include "core/math.h"

namespace planish {

namespace {

constexpr double k_no_rms_strain = 1e-9;

/// What of a result should be small.
struct Price {
  double strain, deviation;
  std::optional<double> bending_ratio;

  bool is_within(const Price& other) const {
    return strain <= other.strain && deviation <= other.deviation &&
           bending_ratio <= other.bending_ratio;
  }
};

Price price_of(const Candidate& point) {
  return {point.strain.rms, point.deviation.rms, point.fairness.bending_ratio};
}

}  // namespace

std::vector<double> frontier_limits(double rms_strain, std::optional<int> points) {
  if (!(rms_strain > k_no_rms_strain)) return {0.0};
  std::vector<double> limits;
  if (points) {
    const double least = std::min(k_candidate_strains.back(), 0.1 * rms_strain);
    for (int i = 1; i < *points; ++i) {
      const double share = static_cast<double>(i) / (*points - 1);
      limits.push_back(std::min(1.0, rms_strain * math::pow(least / rms_strain, share)));
    }
  } else {
    std::copy_if(k_candidate_strains.begin(), k_candidate_strains.end(), std::back_inserter(limits),
                 [&](double limit) { return limit < rms_strain; });
  }
  limits.push_back(0.0);
  return limits;
}

void mark_dominated(FrontierReport& report) {
  std::vector<Price> prices = {price_of(report.design)};
  for (const Candidate& point : report.curve)
    prices.push_back(price_of(point));
  for (auto* points : {&report.curve, &report.others}) {
    for (Candidate& point : *points) {
      const Price own = price_of(point);
      point.dominated = std::any_of(prices.begin(), prices.end(), [&](const Price& other) {
        return other.is_within(own) && !own.is_within(other);
      });
    }
  }
}

}  // namespace planish
