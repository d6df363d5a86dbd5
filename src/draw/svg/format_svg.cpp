#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <numbers>
#include <span>
#include <vector>

#include <planish/draw/format_drawing.h>

#include "core/number_text.h"
#include "draw/cutting_order.h"
#include "draw/svg/svg_layers.h"
#include "draw/text/markup_text.h"
#include "pattern/curves/piece_math.h"

namespace planish {

namespace {

constexpr int k_decimals = 3;
constexpr double k_steps = 1000.0;  // per millimetre: what k_decimals can tell apart

// Height of capitals over the size of the letter's body in common sans-serif fonts.
constexpr double k_capital_height = 0.72;

// A place on the sheet in whole steps, y downwards. Differences of whole numbers are exact, so
// relative coordinates do not drift.
struct Place {
  double x, y;
  friend bool operator==(const Place&, const Place&) = default;
};

void append_place(std::string& svg, Place place) {
  append_fixed(svg, place.x / k_steps, k_decimals);
  svg += ',';
  append_fixed(svg, place.y / k_steps, k_decimals);
}

class SvgLayers {
 public:
  explicit SvgLayers(double height) : height_(height) {}

  void add(const Layer& layer) {
    const std::string name = escape_markup(layer.name);
    begin_layer(name, name, layer.visible);
    for (const DrawingShape& shape : layer.shapes) {
      std::visit([this](const auto& some) { add(some); }, shape);
    }
    svg_ += "</g>\n";
  }

  /// The layers of one piece inside a group; what has nothing of it is left out.
  void add_piece(const std::string& name, std::size_t number, std::span<const Layer> layers) {
    const std::string id = "piece-" + std::to_string(number + 1);
    begin_layer(id, escape_markup(name), true);
    for (const Layer& layer : layers) {
      bool has_begun = false;
      for (const DrawingShape& shape : layer.shapes) {
        const auto add_own = [&](const auto& some) {
          if (some.piece != number) return;
          const std::string of_layer = escape_markup(layer.name);
          if (!has_begun) begin_layer(id + "-" + of_layer, of_layer, layer.visible);
          has_begun = true;
          add(some);
        };
        std::visit(add_own, shape);
      }
      if (has_begun) svg_ += "</g>\n";
    }
    svg_ += "</g>\n";
  }

  std::string take() && { return std::move(svg_); }

 private:
  void begin_layer(const std::string& id, const std::string& label, bool visible) {
    svg_ += "<g id=\"" + id + "\" inkscape:groupmode=\"layer\" inkscape:label=\"" + label + '"';
    if (!visible) svg_ += " style=\"display:none\"";
    svg_ += ">\n";
  }

  Place place_of(Vec2 point) const {
    return {std::round(k_steps * point.x), std::round(k_steps * (height_ - point.y))};
  }

  void add(const Path& path) {
    // Machines that follow the file cut holes first.
    if (path.stroke && path.closed && path.lines.size() > 1) {
      add_path(inner_first(path));
    } else {
      add_path(path);
    }
  }

  void add_path(const Path& path) {
    svg_ += "<path d=\"";
    if (path.fitted.curves.empty()) {
      for (const auto& line : path.lines)
        add_line(line, path.closed);
    }
    for (const Curve& curve : path.fitted.curves)
      add_curve(curve, path.closed);
    svg_ += "\" fill=\"";
    svg_ += path.fill ? hex_text(*path.fill) : "none";
    svg_ += '"';
    if (path.fill && path.lines.size() > 1) svg_ += " fill-rule=\"evenodd\"";
    if (path.stroke) add_stroke(*path.stroke);
    svg_ += "/>\n";
  }

  // The start is absolute, so that also readers that handle relative moves badly get it right.
  void add_line(const std::vector<Vec2>& line, bool closed) {
    bool begun = false;
    Place last = {};
    bool bend = false;  // inside the list that follows an "l"
    for (const Vec2 point : line) {
      const Place place = place_of(point);
      if (!std::isfinite(place.x) || !std::isfinite(place.y) || (begun && place == last)) continue;
      if (begun) {
        svg_ += bend ? ' ' : 'l';
        append_place(svg_, {place.x - last.x, place.y - last.y});
        bend = true;
      } else {
        svg_ += 'M';
        append_place(svg_, place);
        begun = true;
      }
      last = place;
    }
    if (begun && closed) svg_ += 'z';
  }

  void add_places(char command, std::initializer_list<Vec2> points) {
    svg_ += command;
    for (const Vec2 point : points) {
      if (svg_.back() != command) svg_ += ' ';
      append_place(svg_, place_of(point));
    }
  }

  void add_arc(Vec2 start, const ArcTo& arc) {
    const Circle circle = circle_of(start, arc);
    svg_ += 'A';
    append_place(svg_, {k_steps * circle.radius, k_steps * circle.radius});
    svg_ += std::abs(circle.angle) > std::numbers::pi ? " 0 1 " : " 0 0 ";
    // The y axis is turned over: what turns left on the sheet turns right here.
    svg_ += circle.angle > 0.0 ? "0 " : "1 ";
    append_place(svg_, place_of(arc.end));
  }

  void add_curve(const Curve& curve, bool closed) {
    if (curve.pieces.empty()) return;
    add_places('M', {curve.start});
    Vec2 from = curve.start;
    for (const CurvePiece& piece : curve.pieces) {
      if (const auto* cubic = std::get_if<CubicTo>(&piece)) {
        add_places('C', {cubic->first, cubic->second, cubic->end});
      } else if (const auto* arc = std::get_if<ArcTo>(&piece)) {
        add_arc(from, *arc);
      } else {
        add_places('L', {end_of(piece)});
      }
      from = end_of(piece);
    }
    if (closed) svg_ += 'z';
  }

  void add_stroke(const Stroke& stroke) {
    svg_ += " stroke=\"" + hex_text(stroke.color) + "\" stroke-width=\"";
    append_fixed(svg_, stroke.width, k_decimals);
    svg_ += "\" stroke-linejoin=\"round\"";
    if (stroke.dashed) {
      svg_ += " stroke-dasharray=\"";
      append_fixed(svg_, 12 * stroke.width, k_decimals);
      svg_ += ' ';
      append_fixed(svg_, 6 * stroke.width, k_decimals);
      svg_ += '"';
    }
  }

  void add(const Text& text) {
    const Place place = place_of(text.at);
    if (!std::isfinite(place.x) || !std::isfinite(place.y)) return;
    svg_ += "<text x=\"";
    append_fixed(svg_, place.x / k_steps, k_decimals);
    svg_ += "\" y=\"";
    append_fixed(svg_, place.y / k_steps, k_decimals);
    svg_ += "\" font-family=\"sans-serif\" font-size=\"";
    append_fixed(svg_, text.height / k_capital_height, k_decimals);
    svg_ += "\" fill=\"" + hex_text(text.color) + '"';
    if (text.centred) svg_ += " text-anchor=\"middle\"";
    svg_ += '>' + escape_markup(text.text) + "</text>\n";
  }

  double height_;
  std::string svg_;
};

}  // namespace

std::string hex_text(Color color) {
  constexpr char digits[] = "0123456789abcdef";
  std::string text = "#";
  for (const std::uint8_t part : {color.r, color.g, color.b}) {
    text += digits[part >> 4];
    text += digits[part & 15];
  }
  return text;
}

std::string svg_layers(std::span<const Layer> layers, double height) {
  SvgLayers svg(height);
  for (const Layer& layer : layers)
    svg.add(layer);
  return std::move(svg).take();
}

namespace {

/// Whether it is about the sheet and not about a piece.
bool is_of_sheet(const Layer& layer) {
  return layer.name == "label" || layer.name == "legend";
}

/// What is about the sheet, then piece by piece.
std::string svg_pieces(const Drawing& drawing) {
  SvgLayers svg(drawing.height);
  std::vector<Layer> of_pieces;
  const std::size_t count = std::max<std::size_t>(drawing.pieces.size(), 1);
  for (const Layer& layer : drawing.layers) {
    if (is_of_sheet(layer))
      svg.add(layer);
    else
      of_pieces.push_back(layer);
  }
  for (std::size_t p = 0; p < count; ++p) {
    const bool is_named = p < drawing.pieces.size() && !drawing.pieces[p].name.empty();
    svg.add_piece(is_named ? drawing.pieces[p].name : drawing.title, p, of_pieces);
  }
  return std::move(svg).take();
}

}  // namespace

std::string format_svg(const Drawing& drawing, const SvgOptions& options) {
  const std::string width = fixed_text(drawing.width, k_decimals);
  const std::string height = fixed_text(drawing.height, k_decimals);
  std::string svg =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<svg xmlns=\"http://www.w3.org/2000/svg\""
      " xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\""
      " width=\"" +
      width + "mm\" height=\"" + height + "mm\" viewBox=\"0 0 " + width + ' ' + height + "\">\n";
  svg += "<title>" + escape_markup(drawing.title) + "</title>\n";
  svg += options.by_piece ? svg_pieces(drawing) : svg_layers(drawing.layers, drawing.height);
  svg += "</svg>\n";
  return svg;
}

}  // namespace planish
