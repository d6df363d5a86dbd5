#include "report/convergence_chart.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/number_text.h"
#include "report/figure_text.h"
#include "report/log_axis.h"
#include "report/scale_limit.h"

namespace planish {

namespace {

constexpr double k_width = 480.0, k_height = 330.0;
constexpr double k_left = 50.0, k_right = 122.0, k_top = 14.0, k_bottom = 44.0;
constexpr double k_label_distance = 16.0;   // between the baselines of line labels, at least
constexpr std::size_t k_most_points = 400;  // of one line

struct Point {
  double sweep, share;
};

struct Line {
  std::string_view name, css_class;
  std::vector<Point> points;
};

Line line_of(std::string_view name, std::string_view css_class, double before,
             const std::vector<SweepRecord>& history, double SweepRecord::*figure) {
  Line line{name, css_class, {}};
  if (!(before > 0.0) || !std::isfinite(before)) return line;
  line.points.push_back({0.0, 1.0});
  const std::size_t step = history.size() / k_most_points + 1;
  for (std::size_t i = 0; i < history.size(); ++i) {
    if (i % step != 0 && i + 1 != history.size()) continue;
    const double share = history[i].*figure / before;
    if (!(share > 0.0) || !std::isfinite(share)) break;
    line.points.push_back({static_cast<double>(history[i].sweep), share});
  }
  return line;
}

// Short enough for the margin.
std::string share_text(double share) {
  if (share >= 0.01) return significant_text(share, 2);
  if (share >= 1e-4) return "1/" + about_text(1.0 / share);
  return power_of_ten_text(static_cast<int>(std::lround(std::log10(share))));
}

class Chart {
 public:
  Chart(std::vector<Line> lines, double last_sweep)
      : lines_(std::move(lines)), last_sweep_(last_sweep), axis_(axis_of(lines_)) {}

  std::string svg() const {
    std::string svg = "<svg class=\"chart\" viewBox=\"0 0 480 330\" role=\"img\" aria-label=\"" +
                      summary() + "\">\n" + vertical_axis() + horizontal_axis();
    for (const Line& line : lines_)
      svg += polyline(line);
    return svg + line_labels() + "</svg>\n";
  }

 private:
  static LogAxis axis_of(const std::vector<Line>& lines) {
    double low = 1.0, high = 1.0;
    for (const Line& line : lines) {
      for (const Point point : line.points) {
        low = std::min(low, point.share);
        high = std::max(high, point.share);
      }
    }
    return log_axis(low, high);
  }

  double x_of(double sweep) const {
    return k_left + sweep / last_sweep_ * (k_width - k_left - k_right);
  }
  double y_of(double share) const {
    return k_height - k_bottom - axis_.place_of(share) * (k_height - k_top - k_bottom);
  }

  static std::string text(double x, double y, std::string_view anchor, std::string_view css_class,
                          std::string_view words) {
    std::string svg = "<text x=\"" + fixed_text(x, 1) + "\" y=\"" + fixed_text(y, 1) +
                      "\" text-anchor=\"" + std::string(anchor) + "\"";
    if (!css_class.empty()) svg += " class=\"" + std::string(css_class) + "\"";
    return svg + ">" + std::string(words) + "</text>\n";
  }

  std::string vertical_axis() const {
    std::string svg;
    for (const Tick& tick : axis_.ticks) {
      const double y = y_of(tick.value);
      svg += "<path class=\"grid\" d=\"M" + fixed_text(k_left, 1) + ',' + fixed_text(y, 1) + 'H' +
             fixed_text(k_width - k_right, 1) + "\"/>\n";
      svg += text(k_left - 8.0, y + 4.0, "end", "", tick.text);
    }
    return svg;
  }

  std::string horizontal_axis() const {
    const double step = std::max(1.0, round_up_125(last_sweep_ / 6.0));
    std::string svg;
    for (double sweep = 0.0; sweep <= last_sweep_; sweep += step) {
      svg += text(x_of(sweep), k_height - k_bottom + 18.0, "middle", "", number_text(sweep));
    }
    const double middle = 0.5 * (k_left + k_width - k_right);
    return svg + text(middle, k_height - 6.0, "middle", "axis", "sweep");
  }

  std::string polyline(const Line& line) const {
    std::string svg = "<polyline class=\"" + std::string(line.css_class) + "\" points=\"";
    for (const Point point : line.points) {
      svg += fixed_text(x_of(point.sweep), 2) + ',' + fixed_text(y_of(point.share), 2) + ' ';
    }
    svg.back() = '"';
    return svg + "/>\n";
  }

  // At the ends of the lines, pushed apart where they would touch.
  std::string line_labels() const {
    std::vector<const Line*> order;
    for (const Line& line : lines_)
      order.push_back(&line);
    std::stable_sort(order.begin(), order.end(), [](const Line* a, const Line* b) {
      return a->points.back().share > b->points.back().share;
    });
    std::vector<double> places;
    for (const Line* line : order) {
      const double y = y_of(line->points.back().share);
      places.push_back(places.empty() ? y : std::max(y, places.back() + k_label_distance));
    }
    double lowest = k_height - k_bottom;
    for (std::size_t i = places.size(); i-- > 0; lowest -= k_label_distance) {
      places[i] = std::min(places[i], lowest);
    }
    std::string svg;
    for (std::size_t i = 0; i < order.size(); ++i) {
      const Point end = order[i]->points.back();
      svg += text(x_of(end.sweep) + 8.0, places[i] + 4.0, "start", order[i]->css_class,
                  std::string(order[i]->name) + " " + share_text(end.share));
    }
    return svg;
  }

  std::string summary() const {
    std::string words = "After " + number_text(last_sweep_) + " sweeps, as a share of the start:";
    for (const Line& line : lines_) {
      words += ' ' + std::string(line.name) + ' ' + share_text(line.points.back().share) +
               (&line == &lines_.back() ? "." : ",");
    }
    return words;
  }

  std::vector<Line> lines_;
  double last_sweep_;
  LogAxis axis_;
};

}  // namespace

std::string convergence_chart(const Flattenability& before,
                              const std::vector<SweepRecord>& history) {
  std::vector<Line> lines = {
      line_of("e_max", "line-e-max", before.e_max, history, &SweepRecord::e_max),
      line_of("e_avg", "line-e-avg", before.e_avg, history, &SweepRecord::e_avg),
      line_of("energy", "line-energy", before.energy, history, &SweepRecord::energy)};
  std::erase_if(lines, [](const Line& line) { return line.points.empty(); });
  if (history.empty() || lines.empty()) return {};
  return Chart(std::move(lines), static_cast<double>(history.back().sweep)).svg();
}

}  // namespace planish
