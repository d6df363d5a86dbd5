#include <algorithm>
#include <array>
#include <charconv>

#include <planish/flatten/frontier.h>

#include "core/math.h"

namespace planish {

namespace {

constexpr std::array k_usual_limits = {0.05, 0.02, 0.01, 0.005, 0.002, 0.001};
constexpr double k_no_strain = 1e-9;

/// In per cent with at most three digits: "0.5 %".
std::string short_percent(double share) {
  char digits[32];
  const auto end =
      std::to_chars(digits, digits + sizeof digits, 100.0 * share, std::chars_format::general, 3)
          .ptr;
  return std::string(digits, end) + " %";
}

/// What of a result should be small.
struct Price {
  double strain, deviation;
  std::optional<double> bending_ratio;

  bool is_within(const Price& other) const {
    return strain <= other.strain && deviation <= other.deviation &&
           bending_ratio <= other.bending_ratio;
  }
};

Price price_of(const FrontierPoint& point) {
  return {point.strain.rms, point.deviation.rms, point.fairness.bending_ratio};
}

}  // namespace

std::vector<double> frontier_limits(double rms_strain, std::optional<int> points) {
  if (!(rms_strain > k_no_strain)) return {0.0};
  std::vector<double> limits;
  if (points) {
    const double least = std::min(k_usual_limits.back(), 0.1 * rms_strain);
    for (int i = 1; i < *points; ++i) {
      const double share = static_cast<double>(i) / (*points - 1);
      limits.push_back(std::min(1.0, rms_strain * math::pow(least / rms_strain, share)));
    }
  } else {
    std::copy_if(k_usual_limits.begin(), k_usual_limits.end(), std::back_inserter(limits),
                 [&](double limit) { return limit < rms_strain; });
  }
  limits.push_back(0.0);
  return limits;
}

std::string stop_name(const FrontierPoint& point) {
  const auto* options = std::get_if<Auto>(&point.method);
  if (options == nullptr) return std::string(name_of(point.method));
  const std::string end = point.stop == StopReason::strain_met ? "" : ", not met";
  if (options->max_strain > 0.0) return "limit " + short_percent(options->max_strain) + end;
  if (options->max_rms_strain > 0.0) return short_percent(options->max_rms_strain) + " rms" + end;
  return point.flattenable ? "flat" : "as flat as it gets";
}

void mark_dominated(FrontierReport& report) {
  std::vector<Price> prices = {{report.before.rms, 0.0, report.bending_ratio_before}};
  for (const FrontierPoint& point : report.curve)
    prices.push_back(price_of(point));
  for (auto* points : {&report.curve, &report.others}) {
    for (FrontierPoint& point : *points) {
      const Price own = price_of(point);
      point.dominated = std::any_of(prices.begin(), prices.end(), [&](const Price& other) {
        return other.is_within(own) && !own.is_within(other);
      });
    }
  }
}

}  // namespace planish
