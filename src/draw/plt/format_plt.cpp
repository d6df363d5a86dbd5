#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <planish/draw/format_drawing.h>

#include "core/number_text.h"
#include "draw/cutting_order.h"
#include "draw/text/stroke_text.h"
#include "draw/whole_steps.h"

namespace planish {

namespace {

constexpr double k_units = 40.0;            // per millimetre
constexpr std::size_t k_most_points = 100;  // in one instruction: plotters have small buffers
constexpr int k_most_pens = 8;

/// The lines of one layer and piece, in units. Closed ones return to their start.
struct PenLines {
  std::string layer;
  std::vector<std::vector<Vec2>> lines;
};

PenLines pen_lines(const Layer& layer) {
  PenLines pen{layer.name, {}};
  for (const DrawingShape& shape : layer.shapes) {
    const auto* path = std::get_if<Path>(&shape);
    if (path == nullptr || !path->stroke) continue;
    for (const auto& line : path->fitted.few.empty() ? path->lines : path->fitted.few) {
      std::vector<Vec2> places = whole_steps(line, k_units, path->closed);
      if (places.size() < 2) continue;
      if (path->closed) places.push_back(places.front());
      pen.lines.push_back(std::move(places));
    }
  }
  return pen;
}

std::vector<PenLines> all_lines(std::span<const Layer> layers, bool visible) {
  std::vector<PenLines> all;
  for (const Layer& layer : layers) {
    if (layer.visible != visible) continue;
    PenLines pen = pen_lines(layer);
    if (!pen.lines.empty()) all.push_back(std::move(pen));
  }
  return all;
}

/// Of the box around all lines, also those that do not show; nothing without any.
std::optional<Vec2> lower_left(std::span<const PenLines> shown, std::span<const PenLines> hidden) {
  std::optional<Vec2> low;
  for (const std::span<const PenLines> all : {shown, hidden}) {
    for (const PenLines& pen : all) {
      for (const auto& line : pen.lines) {
        for (const Vec2 place : line) {
          if (!low) low = place;
          low = {std::min(low->x, place.x), std::min(low->y, place.y)};
        }
      }
    }
  }
  return low;
}

/// Pen 1 for what is cut, holes too, the others for the other layers that have lines, in the order
/// of the drawing; more than there are pens share the last one.
std::map<std::string, int> pens_of(const Drawing& drawing, std::span<const PenLines> all) {
  const auto has_lines = [&](const std::string& layer) {
    return std::any_of(all.begin(), all.end(),
                       [&](const PenLines& pen) { return pen.layer == layer; });
  };
  std::map<std::string, int> pens;
  int last = 0;
  if (has_lines("cut")) pens["cut"] = pens["hole"] = ++last;
  for (const Layer& layer : drawing.layers) {
    if (!has_lines(layer.name) || pens.contains(layer.name)) continue;
    last = std::min(last + 1, k_most_pens);
    pens[layer.name] = last;
  }
  return pens;
}

void append_point(std::string& plt, Vec2 place) {
  append_fixed(plt, place.x, 0);
  plt += ',';
  append_fixed(plt, place.y, 0);
}

void append_line(std::string& plt, std::span<const Vec2> places, Vec2 origin) {
  plt += "PU";
  append_point(plt, places.front() - origin);
  plt += ";\n";
  for (std::size_t i = 1; i < places.size(); ++i) {
    const bool begins = (i - 1) % k_most_points == 0;
    const bool ends = i % k_most_points == 0 || i + 1 == places.size();
    plt += begins ? "PD" : ",";
    append_point(plt, places[i] - origin);
    if (ends) plt += ";\n";
  }
}

}  // namespace

std::string format_plt(const Drawing& drawing) {
  const std::vector<Layer> layers = in_cutting_order(with_stroked_text(drawing));
  const std::vector<PenLines> all = all_lines(layers, true);
  const std::map<std::string, int> pens = pens_of(drawing, all);
  const Vec2 origin = lower_left(all, all_lines(layers, false)).value_or(Vec2{});
  std::string plt = "IN;\n";
  int taken = 0;
  for (const PenLines& some : all) {
    const int pen = pens.at(some.layer);
    if (pen != taken) plt += "SP" + std::to_string(pen) + ";\n";
    taken = pen;
    for (const auto& line : some.lines)
      append_line(plt, line, origin);
  }
  return plt + "PU;\nSP0;\n";
}

}  // namespace planish
