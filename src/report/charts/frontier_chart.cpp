#include "report/charts/frontier_chart.h"

#include <algorithm>
#include <utility>

#include "core/figure_text.h"
#include "report/charts/log_chart.h"

namespace planish {

namespace {

constexpr double k_floor = 1e-5;  // of strain: what is less nobody can see on a sheet
constexpr std::size_t k_styles = 9;

Vec2 place_of(const Deviation& deviation, double strain) {
  return {100.0 * deviation.rms_over_diagonal, 100.0 * std::max(strain, k_floor)};
}

/// None of the point for the limit: the limit has a line of its own.
std::string name_on_line(const Candidate& point) {
  const auto* options = std::get_if<Auto>(&point.method);
  return options != nullptr && options->limits.both_ways() > 0.0 ? std::string()
                                                                 : candidate_name(point);
}

/// The curve from the patch as designed on: through what nothing nearer beats. The rest is aside.
ChartLine curve(const FrontierReport& report, double EdgeStrain::*figure, std::string name,
                std::string css_class) {
  ChartLine line{
      std::move(name), std::move(css_class), {place_of({}, report.design.strain.*figure)}, true};
  line.point_names = {"as designed"};
  for (const Candidate& point : report.curve) {
    const Vec2 place = place_of(point.deviation, point.strain.*figure);
    if (point.dominated || !(place.y < line.points.back().y)) {
      line.aside.push_back(place);
    } else {
      line.points.push_back(place);
      line.point_names.push_back(name_on_line(point));
    }
  }
  return line;
}

double farthest(const std::vector<ChartLine>& lines) {
  double most = 0.0;
  for (const ChartLine& line : lines) {
    most = std::max(most, line.points.back().x);
    for (const Vec2 point : line.aside)
      most = std::max(most, point.x);
  }
  return most;
}

}  // namespace

std::string frontier_chart(const FrontierReport& report) {
  std::vector<ChartLine> lines = {curve(report, &EdgeStrain::rms, "auto, rms", "line-0"),
                                  curve(report, &EdgeStrain::max, "auto, largest", "line-1")};
  // Styles 0 to 2 are those of the curves and the limit.
  std::size_t style = 3;
  for (const Candidate& point : report.others) {
    lines.push_back({std::string(name_of(point.method)),
                     "line-" + std::to_string(style),
                     {place_of(point.deviation, point.strain.rms)}});
    style = style + 1 < k_styles ? style + 1 : 3;
  }
  lines[1].point_names.clear();
  const double end = farthest(lines);
  if (!(end > 0.0)) return {};
  if (const double limit = report.limits.both_ways(); limit > 0.0) {
    const double y = 100.0 * limit;
    lines.push_back({"limit " + percent_text(limit), "line-2", {{0.0, y}, {end, y}}});
  }
  return log_chart(lines, ChartScale::linear, "rms deviation, % of the diagonal",
                   "Strain of the pattern in % against rms deviation in % of the diagonal.");
}

}  // namespace planish
