#include "text/carry_text.h"

#include <planish_json/json.h>

#include "shell/text.h"
#include "text/lengths.h"

namespace planish::cli {

std::string carry_text(const CarryFigures& figures, const std::string& from, Unit unit) {
  const ShownLengths lengths(unit);
  std::string text = counted(figures.lines, "line") + " and " + counted(figures.points, "point");
  if (figures.lines > 0) {
    text += "; " + lengths.text(figures.length_from) + " of line became " +
            lengths.text(figures.length_to);
  }
  text = wrapped(text, 0) + "\n";
  if (figures.outside_length > 0.0 || figures.outside_points > 0) {
    text +=
        wrapped("Left out, as it lies off " + from + ": " + lengths.text(figures.outside_length) +
                    " of line and " + counted(figures.outside_points, "point"),
                0) +
        "\n";
  }
  return text;
}

std::string carry_json(const CarryFigures& figures, Unit unit, const std::string& output) {
  const Json object = {
      {"unit", to_string(unit)},
      {"lines", figures.lines},
      {"points", figures.points},
      {"length_from", figures.length_from},
      {"length_to", figures.length_to},
      {"outside", {{"length", figures.outside_length}, {"points", figures.outside_points}}},
      {"farthest", figures.farthest},
      {"left_out", Json(figures.left_out)},
      {"output", output}};
  return json_document(object) + "\n";
}

}  // namespace planish::cli
