#include "report/charts/defect_histogram.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include <planish/measure/flattenability.h>

#include "core/figure_text.h"
#include "core/math.h"
#include "core/number_text.h"

namespace planish {

namespace {

constexpr double k_left = 46.0, k_right = 468.0, k_top = 40.0, k_bottom = 286.0;
constexpr int k_lowest = -24;      // half decades: 1e-12
constexpr int k_fewest_bins = 12;  // so that bars never get fat

/// In half decades.
int bin_of(double defect) {
  const double size = std::abs(defect);
  if (!(size > 0.0)) return k_lowest;
  return std::max(k_lowest, static_cast<int>(std::floor(2.0 * math::log10(size))));
}

std::vector<double> shares(std::span<const double> defects, int low, int high) {
  std::vector<double> share(static_cast<std::size_t>(high - low + 1), 0.0);
  for (const double defect : defects)
    share[static_cast<std::size_t>(bin_of(defect) - low)] += 1.0;
  for (double& count : share)
    count /= static_cast<double>(std::max<std::size_t>(1, defects.size()));
  return share;
}

class Histogram {
 public:
  Histogram(std::span<const double> before, std::span<const double> after) {
    int high = 2 * static_cast<int>(std::lround(math::log10(k_flattenable_e_max))) + 1;
    low_ = high - 2;
    for (const auto& list : {before, after}) {
      for (const double defect : list) {
        low_ = std::min(low_, bin_of(defect));
        high = std::max(high, bin_of(defect));
      }
    }
    low_ = std::min(low_, high + 1 - k_fewest_bins);
    before_ = shares(before, low_, high);
    after_ = shares(after, low_, high);
    for (const auto* list : {&before_, &after_})
      top_ = std::max(top_, *std::max_element(list->begin(), list->end()));
  }

  std::string svg() const {
    std::string svg = "<svg class=\"chart\" viewBox=\"0 0 480 330\" role=\"img\" aria-label=\"" +
                      std::string(
                          "Share of the places by how far they are from flat, before and "
                          "after") +
                      "\">\n" + horizontal_lines();
    const double width = step();
    for (std::size_t i = 0; i < before_.size(); ++i) {
      const double x = k_left + width * static_cast<double>(i);
      svg += bar("bar-before", x + 0.08 * width, 0.4 * width, before_[i]) +
             bar("bar-after", x + 0.52 * width, 0.4 * width, after_[i]);
    }
    return svg + decades() + bound() + keys() + "</svg>\n";
  }

 private:
  double step() const { return (k_right - k_left) / static_cast<double>(before_.size()); }
  double x_of(int half_decade) const { return k_left + step() * (half_decade - low_); }
  double y_of(double share) const { return k_bottom - share / top_ * (k_bottom - k_top); }

  static std::string text(double x, double y, const std::string& anchor, const std::string& words) {
    return "<text x=\"" + fixed_text(x, 1) + "\" y=\"" + fixed_text(y, 1) + "\" text-anchor=\"" +
           anchor + "\">" + words + "</text>\n";
  }

  std::string bar(const std::string& css_class, double x, double width, double share) const {
    if (!(share > 0.0)) return {};
    const double height = std::max(0.8, k_bottom - y_of(share));
    return "<rect class=\"" + css_class + "\" x=\"" + fixed_text(x, 2) + "\" y=\"" +
           fixed_text(k_bottom - height, 2) + "\" width=\"" + fixed_text(width, 2) +
           "\" height=\"" + fixed_text(height, 2) + "\"/>\n";
  }

  std::string horizontal_lines() const {
    std::string svg;
    const double pitch = top_ > 0.5 ? 0.2 : top_ > 0.2 ? 0.1 : 0.05;
    for (int i = 0; i * pitch <= top_; ++i) {
      const double y = y_of(i * pitch);
      svg += "<path class=\"grid\" d=\"M" + fixed_text(k_left, 1) + ',' + fixed_text(y, 1) + 'H' +
             fixed_text(k_right, 1) + "\"/>\n" +
             text(k_left - 8.0, y + 4.0, "end", fixed_text(100.0 * i * pitch, 0) + " %");
    }
    return svg;
  }

  std::string decades() const {
    std::string svg;
    const int decades = static_cast<int>(before_.size()) / 2;
    const int pitch = decades > 8 ? 4 : 2;  // half decades between numbers
    for (int i = low_; i <= low_ + static_cast<int>(before_.size()); ++i) {
      if (i % pitch == 0)
        svg += text(x_of(i), k_bottom + 18.0, "middle", i == 0 ? "1" : power_of_ten_text(i / 2));
    }
    return svg + "<text class=\"axis\" x=\"" + fixed_text(0.5 * (k_left + k_right), 1) +
           "\" y=\"324\" text-anchor=\"middle\">angle that is missing or too much, rad</text>\n";
  }

  std::string bound() const {
    const double x = x_of(2 * static_cast<int>(std::lround(math::log10(k_flattenable_e_max))));
    return "<path class=\"bound\" d=\"M" + fixed_text(x, 1) + ',' + fixed_text(k_top - 8.0, 1) +
           'V' + fixed_text(k_bottom, 1) + "\"/>\n" +
           text(x - 6.0, k_top - 2.0, "end", "flat enough");
  }

  static std::string keys() {
    return "<rect class=\"bar-before\" x=\"300\" y=\"4\" width=\"10\" height=\"10\"/>\n" +
           text(316.0, 13.0, "start", "before") +
           "<rect class=\"bar-after\" x=\"386\" y=\"4\" width=\"10\" height=\"10\"/>\n" +
           text(402.0, 13.0, "start", "after");
  }

  int low_ = 0;
  double top_ = 0.0;
  std::vector<double> before_, after_;
};

}  // namespace

std::string defect_histogram(std::span<const double> before, std::span<const double> after) {
  if (before.empty() || after.empty()) return {};
  return Histogram(before, after).svg();
}

}  // namespace planish
