#include "report/legend.h"

#include "draw/svg_layers.h"
#include "report/strain_map.h"

namespace planish {

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
