#include <array>
#include <string_view>

#include <planish/flatten/frontier.h>

#include "draw/text/markup_text.h"
#include "report/charts/frontier_chart.h"

namespace planish {

namespace {

// Plain colours: not every program that opens SVG knows variables.
constexpr std::string_view k_style =
    "text{font:13px sans-serif;fill:#66676b}"
    ".point{font-size:10.5px}"
    ".grid{stroke:#e2e1dc;fill:none}"
    "polyline{fill:none;stroke-width:2.2;stroke-linejoin:round}"
    ".leader{fill:none;stroke-width:.8;opacity:.55}"
    "polyline.line-1{stroke-dasharray:9 5}"
    "polyline.line-2{stroke-dasharray:2 4}";

constexpr std::array<std::string_view, 9> k_colors = {"#1e1f21", "#0067a5", "#c05000",
                                                      "#007a5a", "#9c3587", "#7d6b00",
                                                      "#3d86c6", "#7a4a28", "#c2183c"};

std::string style() {
  std::string css(k_style);
  for (std::size_t i = 0; i < k_colors.size(); ++i) {
    const std::string line = ".line-" + std::to_string(i);
    const std::string color(k_colors[i]);
    css += "polyline" + line + ",path" + line + "{stroke:" + color + "}circle" + line + ",text" +
           line + "{fill:" + color + "}";
  }
  return css;
}

std::string chart_or_words(const FrontierReport& report) {
  std::string chart = frontier_chart(report);
  if (!chart.empty()) return chart;
  return "<text x=\"16\" y=\"44\">Nothing to show: no vertex had to move.</text>\n";
}

}  // namespace

std::string frontier_svg(const FrontierReport& report) {
  // The chart is 330 high and stands in the middle: there is room for a line above it.
  const std::string name = report.name.empty() ? "Patch" : escape_markup(report.name);
  const std::string heading = name + ": strain of the pattern, %; dots of other methods: rms";
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"960\" height=\"740\" viewBox=\"0 0 "
         "480 370\">\n<title>" +
         heading + "</title>\n<style>" + style() +
         "</style>\n<rect width=\"480\" height=\"370\" fill=\"#ffffff\"/>\n<text x=\"16\" "
         "y=\"20\">" +
         heading + "</text>\n" + chart_or_words(report) + "</svg>\n";
}

}  // namespace planish
