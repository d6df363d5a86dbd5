#include "model/material_text.h"

#include <charconv>

#include <planish_json/json.h>

#include "model/material_file.h"
#include "shell/text.h"

namespace planish::cli {

namespace {

constexpr std::size_t k_name_column = 16, k_limit_column = 14, k_way_column = 13;

/// "12 %", with four significant digits at most.
std::string per_cent(const MaterialFigure& figure) {
  char text[32];
  const auto end =
      std::to_chars(text, text + sizeof text, 100.0 * figure.strain, std::chars_format::general, 4);
  return std::string(text, end.ptr) + " %";
}

/// "12 %", "8 % (15 %)"
std::string both_figures(const MaterialLimit& limit) {
  return per_cent(limit.usual) + (limit.largest ? " (" + per_cent(*limit.largest) + ")" : "");
}

std::string figure_line(const std::string& way, const std::string& text) {
  return left(way, k_way_column) + wrapped(text, k_way_column) + "\n";
}

std::string lines_of(const std::string& way, const MaterialLimit& limit) {
  const MaterialFigure& usual = limit.usual;
  std::string text =
      figure_line(way, per_cent(usual) + " on 99 % of the area. Source: " + usual.source);
  if (!limit.largest) return text;
  const bool is_same = limit.largest->source == usual.source;
  return text + figure_line("", per_cent(*limit.largest) + " at most. Source: " +
                                    (is_same ? "the same" : limit.largest->source));
}

}  // namespace

std::string materials_table(std::span<const Material> materials) {
  std::string text = left("material", k_name_column) + left("stretch", k_limit_column) +
                     left("compression", k_limit_column) + "for\n";
  for (const Material& material : materials) {
    text += left(material.name, k_name_column) +
            left(both_figures(material.stretch), k_limit_column) +
            left(both_figures(material.compression), k_limit_column) +
            wrapped(material.use, k_name_column + 2 * k_limit_column) + "\n";
  }
  return text + "\n" +
         wrapped(
             "Shares of the length on the form, on 99 % of the area; at most, in parentheses. "
             "Guide values: test your sheet, and write its own file (docs/materials.md).",
             0) +
         "\n";
}

std::string material_text(const Material& material) {
  const std::string use = material.use.empty() ? "" : ": " + material.use;
  return wrapped(material.name + use, 2) + "\n\n" + lines_of("stretch", material.stretch) +
         lines_of("compression", material.compression);
}

std::string materials_json(std::span<const Material> materials) {
  Json list = Json::array();
  for (const Material& material : materials)
    list.push_back(material_json(material));
  return json_document({{"materials", list}});
}

}  // namespace planish::cli
