#include "text/frontier_text.h"

#include <algorithm>

#include "shell/text.h"

namespace planish::cli {

namespace {

constexpr std::size_t k_name_width = 23, k_width = 9, k_narrow_width = 7;

/// In per cent and without the sign: the heads have it.
std::string in_percent(double share) {
  const std::string text = percent(share);
  return text.substr(0, text.size() - 2);
}

std::string row(const std::string& name, const std::string& rms, const std::string& largest,
                const std::string& deviation, const std::string& far, const std::string& bending,
                const std::string& added, const std::string& smooth) {
  return left(name, k_name_width) + right(rms, k_width) + right(largest, k_width) +
         right(deviation, k_width) + right(far, k_width) + right(bending, k_width - 1) +
         right(added, k_narrow_width - 1) + right(smooth, k_narrow_width) + "\n";
}

std::string ratio(const std::optional<double>& value) {
  return value ? fixed(*value, 2) : "-";
}

std::string point_row(const std::string& name, const FrontierPoint& point) {
  return row(name, in_percent(point.strain.rms), in_percent(point.strain.max),
             in_percent(point.deviation.rms_over_diagonal), digits(point.deviation.max, 3),
             ratio(point.fairness.bending_ratio), ratio(point.fairness.bending_added),
             point.fairness.is_smooth() ? "yes" : "no");
}

/// With a star where it is dominated.
std::string starred_name(const FrontierPoint& point) {
  return stop_name(point) + (point.dominated ? " *" : "");
}

/// What the star means, where there is one.
std::string star_text(const FrontierReport& report) {
  const auto is_dominated = [](const FrontierPoint& point) { return point.dominated; };
  if (std::none_of(report.curve.begin(), report.curve.end(), is_dominated) &&
      std::none_of(report.others.begin(), report.others.end(), is_dominated))
    return {};
  return "\n" +
         wrapped(
             "* dominated: another point of auto, or the patch as designed, has less rms strain, "
             "rms deviation or bending, and no more of the others.",
             0) +
         "\n";
}

std::string limit_text(const FrontierReport& report) {
  if (!report.limit) return {};
  const auto within = report.first_within_limit();
  const std::string limit = percent(*report.limit);
  if (!within) return "\nNo point of the curve keeps the limit of " + limit + ".\n";
  const FrontierPoint& point = report.curve[*within];
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
  const std::string unit(to_string(report.unit));
  std::string text =
      row("", "strain", "strain", "moved", "moved", "bending", "added", "smooth") +
      row("", "rms %", "most %", "rms %", "most " + unit, "ratio", "ratio", "") +
      row("as designed", in_percent(report.before.rms), in_percent(report.before.max), "0", "0",
          ratio(report.bending_ratio_before), "-", "-") +
      "auto\n";
  for (const FrontierPoint& point : report.curve)
    text += point_row("  " + starred_name(point), point);
  for (const FrontierPoint& point : report.others)
    text += point_row(starred_name(point), point);
  return text + "\n" +
         wrapped(
             "Moved, rms, is in per cent of the bounding box's diagonal; bending is that of the "
             "result over that of the patch, added what of it is new.",
             0) +
         "\n" + star_text(report) + limit_text(report);
}

}  // namespace planish::cli
