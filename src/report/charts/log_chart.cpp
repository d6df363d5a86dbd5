#include "report/charts/log_chart.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>

#include "core/number_text.h"
#include "draw/scale_limit.h"
#include "report/charts/log_axis.h"

namespace planish {

namespace {

constexpr double k_width = 480.0, k_height = 330.0;
constexpr double k_top_room = 14.0, k_bottom_room = 44.0;
constexpr double k_letter = 7.6;           // width of a letter of a name, about
constexpr double k_label_distance = 16.0;  // between the baselines of names, at least
constexpr double k_tick_distance = 38.0;   // between the middles of numbers below the axis
constexpr double k_point_distance = 0.75;  // what is nearer to the last point is not seen
constexpr double k_small_letter = 5.4, k_small_line = 10.0;  // of the names of points
constexpr double k_stub = 0.08;  // of the width, from 0 to where a log axis begins

std::size_t letters_of(std::string_view text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0) != 0x80;
  }));
}

/// From 0 on, with the ticks' places as shares of the width.
class HorizontalAxis {
 public:
  HorizontalAxis(const std::vector<ChartLine>& lines, ChartScale scale) : scale_(scale) {
    double least = std::numeric_limits<double>::infinity();
    for (const ChartLine& line : lines) {
      last_ = std::max(last_, line.points.back().x);
      for (const Vec2 point : line.aside)
        last_ = std::max(last_, point.x);
      for (const Vec2 point : line.points) {
        if (point.x > 0.0) least = std::min(least, point.x);
      }
    }
    if (scale == ChartScale::logarithmic) {
      axis_ = log_axis(least, std::max(last_, 3.0 * least));
      // No empty decades at the ends: the ticks there need not be reached.
      axis_.low = least;
      axis_.high = std::max(last_, 3.0 * least);
      ticks_.push_back({0.0, "0"});
      std::copy_if(axis_.ticks.begin(), axis_.ticks.end(), std::back_inserter(ticks_),
                   [&](const Tick& tick) {
                     return tick.value >= 0.99 * axis_.low && tick.value <= 1.01 * axis_.high;
                   });
    } else {
      const double least_step = scale == ChartScale::whole ? 1.0 : 0.0;
      const double step = std::max(least_step, round_up_125(last_ / 6.0));
      for (int i = 0; i * step <= last_; ++i)
        ticks_.push_back({i * step, fixed_text(i * step, 6)});
    }
  }

  const std::vector<Tick>& ticks() const { return ticks_; }
  double place_of(double x) const {
    if (scale_ != ChartScale::logarithmic) return x / last_;
    return x > 0.0 ? k_stub + (1.0 - k_stub) * axis_.place_of(x) : 0.0;
  }

 private:
  ChartScale scale_;
  double last_ = 0.0;
  LogAxis axis_ = {};
  std::vector<Tick> ticks_;
};

class Chart {
 public:
  Chart(const std::vector<ChartLine>& lines, ChartScale x_scale)
      : lines_(lines), horizontal_(lines, x_scale), vertical_(axis_of(lines)) {
    std::size_t letters = 14;
    for (const ChartLine& line : lines)
      letters = std::max(letters, letters_of(line.name));
    std::size_t digits = 4;
    for (const Tick& tick : vertical_.ticks)
      digits = std::max(digits, letters_of(tick.text));
    left_ = 16.0 + 8.5 * static_cast<double>(digits);
    right_ = k_width - 20.0 - k_letter * static_cast<double>(letters);
  }

  std::string svg(std::string_view x_name, std::string_view label) const {
    std::string svg = "<svg class=\"chart\" viewBox=\"0 0 480 330\" role=\"img\" aria-label=\"" +
                      std::string(label) + "\">\n" + vertical_axis() + horizontal_axis(x_name);
    for (const ChartLine& line : lines_)
      svg += polyline(line) + point_names(line);
    return svg + names() + "</svg>\n";
  }

 private:
  static LogAxis axis_of(const std::vector<ChartLine>& lines) {
    double low = lines.front().points.front().y, high = low;
    for (const ChartLine& line : lines) {
      for (const auto* points : {&line.points, &line.aside}) {
        for (const Vec2 point : *points) {
          low = std::min(low, point.y);
          high = std::max(high, point.y);
        }
      }
    }
    return log_axis(low, high);
  }

  double x_of(double x) const { return left_ + horizontal_.place_of(x) * (right_ - left_); }
  double y_of(double y) const {
    return k_height - k_bottom_room -
           vertical_.place_of(y) * (k_height - k_top_room - k_bottom_room);
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
    for (const Tick& tick : vertical_.ticks) {
      const double y = y_of(tick.value);
      svg += "<path class=\"grid\" d=\"M" + fixed_text(left_, 1) + ',' + fixed_text(y, 1) + 'H' +
             fixed_text(right_, 1) + "\"/>\n";
      svg += text(left_ - 8.0, y + 4.0, "end", "", tick.text);
    }
    return svg;
  }

  std::string horizontal_axis(std::string_view name) const {
    std::string svg;
    double last = -k_tick_distance;
    for (const Tick& tick : horizontal_.ticks()) {
      const double x = x_of(tick.value);
      // The stub for 0 is narrow.
      if (x - last < (tick.value > 0.0 && last == left_ ? 18.0 : k_tick_distance)) continue;
      svg += text(x, k_height - k_bottom_room + 18.0, "middle", "", tick.text);
      last = x;
    }
    return svg + text(0.5 * (left_ + right_), k_height - 6.0, "middle", "axis", name);
  }

  std::string polyline(const ChartLine& line) const {
    std::string svg = "<polyline class=\"" + line.css_class + "\" points=\"";
    double last = -1.0;
    for (const Vec2& point : line.points) {
      const double x = x_of(point.x);
      if (x - last < k_point_distance && &point != &line.points.back()) continue;
      svg += fixed_text(x, 2) + ',' + fixed_text(y_of(point.y), 2) + ' ';
      last = x;
    }
    svg.back() = '"';
    svg += "/>\n";
    for (const Vec2 point : line.aside)
      svg += dot({x_of(point.x), y_of(point.y)}, line.css_class);
    if (!line.has_dots) return svg;
    for (const Vec2 point : line.points)
      svg += dot({x_of(point.x), y_of(point.y)}, line.css_class);
    return svg;
  }

  // Below and to the left, where a line that falls leaves room; beside the axis on the other side.
  std::string point_names(const ChartLine& line) const {
    std::string svg;
    Vec2 last = {-k_width, -k_height};
    for (std::size_t i = 0; i < line.point_names.size(); ++i) {
      const std::string& name = line.point_names[i];
      const Vec2 point = {x_of(line.points[i].x), y_of(line.points[i].y)};
      const double width = k_small_letter * static_cast<double>(letters_of(name));
      if (name.empty() || (std::abs(point.y - last.y) < k_small_line && point.x - last.x < width))
        continue;
      const bool on_left = point.x - 5.0 - width > left_;
      svg += on_left ? text(point.x - 5.0, point.y + 10.0, "end", "point", name)
                     : text(point.x + 4.0, point.y - 5.0, "start", "point", name);
      last = point;
    }
    return svg;
  }

  static std::string dot(Vec2 place, const std::string& css_class) {
    return "<circle class=\"" + css_class + "\" cx=\"" + fixed_text(place.x, 1) + "\" cy=\"" +
           fixed_text(place.y, 1) + "\" r=\"2.6\"/>\n";
  }

  // Of the lines' ends from above to below, pushed apart where the names would touch.
  std::string names() const {
    std::vector<const ChartLine*> order;
    for (const ChartLine& line : lines_)
      order.push_back(&line);
    std::stable_sort(order.begin(), order.end(), [](const ChartLine* a, const ChartLine* b) {
      return a->points.back().y > b->points.back().y;
    });
    std::vector<double> places;
    for (const ChartLine* line : order) {
      const double y = y_of(line->points.back().y);
      places.push_back(places.empty() ? y : std::max(y, places.back() + k_label_distance));
    }
    double lowest = k_height - k_bottom_room;
    for (std::size_t i = places.size(); i-- > 0; lowest -= k_label_distance) {
      places[i] = std::min(places[i], lowest);
    }
    std::string svg;
    for (std::size_t i = 0; i < order.size(); ++i) {
      const Vec2 end = order[i]->points.back();
      svg += leader({x_of(end.x), y_of(end.y)}, places[i], order[i]->css_class) +
             text(right_ + 12.0, places[i] + 4.0, "start", order[i]->css_class, order[i]->name);
    }
    return svg;
  }

  // A dot at the end of a line and, where the name is elsewhere, a thin line to it.
  std::string leader(Vec2 end, double name_y, const std::string& css_class) const {
    std::string svg = dot(end, css_class);
    if (end.x > right_ - 1.0 && std::abs(end.y - name_y) < 3.0) return svg;
    return svg + "<path class=\"leader " + css_class + "\" d=\"M" + fixed_text(end.x, 1) + ',' +
           fixed_text(end.y, 1) + 'L' + fixed_text(right_ + 9.0, 1) + ',' + fixed_text(name_y, 1) +
           "\"/>\n";
  }

  const std::vector<ChartLine>& lines_;
  HorizontalAxis horizontal_;
  LogAxis vertical_;
  double left_ = 0.0, right_ = k_width;
};

}  // namespace

std::string log_chart(const std::vector<ChartLine>& lines, ChartScale x_scale,
                      std::string_view x_name, std::string_view label) {
  return Chart(lines, x_scale).svg(x_name, label);
}

}  // namespace planish
