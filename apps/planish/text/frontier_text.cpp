#include "text/frontier_text.h"

#include <algorithm>

#include "shell/text.h"
#include "text/candidates_text.h"
#include "text/lengths.h"

namespace planish::cli {

namespace {

/// What the star means, where there is one.
std::string star_text(const FrontierReport& report) {
  const auto is_dominated = [](const Candidate& point) { return point.dominated; };
  if (std::none_of(report.curve.begin(), report.curve.end(), is_dominated) &&
      std::none_of(report.others.begin(), report.others.end(), is_dominated))
    return {};
  return "\n" +
         wrapped(
             "* dominated: another point of auto, or the patch as designed, has less rms strain, "
             "rms move or bending, and no more of the others.",
             0) +
         "\n";
}

std::string limit_text(const FrontierReport& report) {
  if (!report.limits.any()) return {};
  const auto within = report.first_within_limit();
  const std::string limit = percent(report.limits.both_ways());
  if (!within) return "\nNo point of the curve keeps the limit of " + limit + ".\n";
  const Candidate& point = report.curve[*within];
  return "\n" +
         wrapped("The limit of " + limit + " is kept at an rms deviation of " +
                     percent(point.deviation.rms_over_diagonal) + " of the diagonal, " +
                     digits(point.deviation.max, 3) + " " + std::string(to_string(report.unit)) +
                     " at most.",
                 0) +
         "\n";
}

}  // namespace

std::string frontier_text(const FrontierReport& report) {
  const ShownLengths lengths(report.unit);
  const auto row_of = [&](const Candidate& point) {
    return candidate_row(point.dominated ? "* " : "", point, lengths);
  };
  std::string text = candidate_head(lengths) + row_of(report.design);
  for (const Candidate& point : report.curve)
    text += row_of(point);
  if (!report.others.empty()) text += "\nOther methods:\n";
  for (const Candidate& point : report.others)
    text += row_of(point);
  return text + "\n" +
         wrapped(
             "Moved is the distance from the design. Bending is that of the result over that of "
             "the design; added and lost are its parts. Fold is the sharpest new one. ! marks what "
             "is not smooth or does not keep the form.",
             0) +
         "\n" + star_text(report) + limit_text(report);
}

}  // namespace planish::cli
