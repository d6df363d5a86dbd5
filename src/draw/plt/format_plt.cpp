#include <cstddef>
#include <span>

#include <planish/draw/format_drawing.h>

#include "core/number_text.h"
#include "draw/text/stroke_text.h"
#include "draw/whole_steps.h"

namespace planish {

namespace {

constexpr double k_units = 40.0;            // per millimetre
constexpr std::size_t k_most_points = 100;  // in one instruction: plotters have small buffers

void append_point(std::string& plt, Vec2 place) {
  append_fixed(plt, place.x, 0);
  plt += ',';
  append_fixed(plt, place.y, 0);
}

void append_line(std::string& plt, std::vector<Vec2> places, bool closed) {
  if (places.size() < 2) return;
  if (closed) places.push_back(places.front());
  plt += "PU";
  append_point(plt, places.front());
  plt += ";\n";
  for (std::size_t i = 1; i < places.size(); ++i) {
    const bool begins = (i - 1) % k_most_points == 0;
    const bool ends = i % k_most_points == 0 || i + 1 == places.size();
    plt += begins ? "PD" : ",";
    append_point(plt, places[i]);
    if (ends) plt += ";\n";
  }
}

std::string lines_of(const Layer& layer) {
  std::string plt;
  for (const DrawingShape& shape : layer.shapes) {
    const auto* path = std::get_if<Path>(&shape);
    if (path == nullptr || !path->stroke) continue;
    for (const auto& line : path->fitted.few.empty() ? path->lines : path->fitted.few)
      append_line(plt, whole_steps(line, k_units, path->closed), path->closed);
  }
  return plt;
}

}  // namespace

std::string format_plt(const Drawing& drawing) {
  std::string plt = "IN;\n";
  int pen = 0;
  for (const Layer& layer : with_stroked_text(drawing).layers) {
    const std::string lines = layer.visible ? lines_of(layer) : std::string();
    if (lines.empty()) continue;
    plt += "SP" + std::to_string(++pen) + ";\n" + lines;
  }
  return plt + "PU;\nSP0;\n";
}

}  // namespace planish
