#include "report/page/legend.h"

#include "core/number_text.h"
#include "draw/svg/svg_layers.h"
#include "sheet/limit_map.h"
#include "sheet/strain_map.h"

namespace planish {

namespace {

std::string field(double left, double width, Color color) {
  return "<rect x=\"" + number_text(left) + "\" width=\"" + number_text(width) +
         "\" height=\"1\" fill=\"" + hex_text(color) + "\"/>";
}

}  // namespace

std::string limit_legend() {
  constexpr double gap = 0.3, beyond = 2.7;
  std::string html =
      "<div class=\"legend bounded\"><svg viewBox=\"0 0 13 1\" preserveAspectRatio=\"none\" "
      "shape-rendering=\"crispEdges\" aria-hidden=\"true\">";
  constexpr int within = k_limit_bands - 1;
  for (int band = 0; band < within; ++band)
    html += field(band, 1.05, limit_band_color(band));
  return html + field(within + gap, beyond, k_beyond_limit) +
         "</svg><div><span><b>0</b></span><span><b>50\u00A0%</b></span>"
         "<span><b>100\u00A0%</b></span><span>beyond</span></div></div>\n";
}

std::string legend(std::span<const Color> fields, const LegendLabels& labels) {
  const std::string count = std::to_string(fields.size());
  std::string html = "<div class=\"legend\"><svg viewBox=\"0 0 " + count +
                     " 1\" preserveAspectRatio=\"none\" shape-rendering=\"crispEdges\""
                     " aria-hidden=\"true\">";
  for (std::size_t i = 0; i < fields.size(); ++i) {
    html += "<rect x=\"" + std::to_string(i) + "\" width=\"1.05\" height=\"1\" fill=\"" +
            hex_text(fields[i]) + "\"/>";
  }
  html += "</svg><div><span>" + labels.low + "</span><span>" + labels.middle + "</span><span>" +
          labels.high + "</span></div></div>\n";
  return html;
}

std::vector<Color> fields_of(ColorMap map) {
  constexpr int steps = 40;
  std::vector<Color> fields;
  for (int i = 0; i <= steps; ++i) {
    const double share = static_cast<double>(i) / steps;
    fields.push_back(color_at(map, map == ColorMap::diverging ? 2.0 * share - 1.0 : share));
  }
  return fields;
}

std::vector<Color> strain_map_fields() {
  std::vector<Color> fields;
  for (int band = -k_bands_a_side; band <= k_bands_a_side; ++band) {
    fields.push_back(band_color(band));
  }
  return fields;
}

}  // namespace planish
