#include "text/ways_text.h"

#include <algorithm>
#include <cmath>

#include "shell/text.h"
#include "shell/values.h"
#include "text/lengths.h"

namespace planish::cli {

namespace {

constexpr std::size_t k_length = 10, k_fold = 10;

/// As a flag takes it: "0.5%".
std::string in_percent(double share) {
  constexpr double parts = 1e8;  // of a per cent: 3.5, not 3.5000000000000004
  return shortest(std::round(100.0 * parts * share) / parts) + "%";
}

std::string flag_of(const Way& way) {
  if (!way.material.empty()) {
    const std::string limit = way.has_one_limit() ? " (" + percent(way.limit()) + ")" : "";
    return "--material " + way.material + limit;
  }
  if (way.limits.rms > 0.0) return "--max-rms-strain " + in_percent(way.limits.rms);
  return "--max-strain " +
         (way.limits.p99 > 0.0 ? in_percent(way.limit()) + "@p99" : in_percent(way.limits.max));
}

/// What happens to the form; of a way that does not reach its limit, how near it comes.
std::string end_of(const Way& way) {
  if (!way.reached) {
    const double left = way.limits.rms > 0.0   ? way.strain.rms
                        : way.limits.p99 > 0.0 ? way.strain.p99
                                               : way.strain.max;
    return "not reached: " + percent(left) + " left";
  }
  if (way.fairness.unchanged) return way.estimated ? "about as designed" : "as designed";
  return way.keeps_form() ? "kept" : "not kept";
}

std::string row(const Way& way, std::size_t flag_width, const ShownLengths& lengths) {
  const std::string about = way.estimated ? "~" : "";
  const double fold = way.sharpest_fold();
  return "  " + left(flag_of(way), flag_width) +
         right(about + lengths.number(way.deviation.rms), k_length) +
         right(about + lengths.number(way.deviation.max), k_length) +
         right(fold > 0.0 ? about + fixed(fold, 0) : "-", k_fold) + "  " + end_of(way) + "\n";
}

}  // namespace

std::string ways_text(const FlattenReport& report) {
  if (report.ways.empty()) return {};
  const ShownLengths lengths(report.unfold.unit);
  const auto is_estimate = [](const Way& way) { return way.estimated; };
  const bool has_estimates = std::any_of(report.ways.begin(), report.ways.end(), is_estimate);
  std::size_t flag_width = 0;
  for (const Way& way : report.ways)
    flag_width = std::max(flag_width, flag_of(way).size());
  std::string text = "Less stretch costs form:\n  " + left("", flag_width) +
                     right("moved " + lengths.unit(), k_length) +
                     right("most " + lengths.unit(), k_length) + right("fold deg", k_fold) +
                     "  form\n";
  for (const Way& way : report.ways)
    text += row(way, flag_width, lengths);
  return text + (has_estimates ? "  ~ is an estimate, of a coarse mesh\n" : "");
}

}  // namespace planish::cli
