#include "draw/pdf/pdf_content.h"

#include <cmath>
#include <cstddef>

#include "core/number_text.h"
#include "draw/pdf/pdf_text.h"
#include "draw/text/stroke_text.h"
#include "draw/whole_steps.h"
#include "pattern/curves/piece_math.h"

namespace planish {

namespace {

constexpr int k_decimals = 3;
constexpr double k_steps = 1000.0;  // per millimetre: what k_decimals can tell apart

std::string_view painting(const Path& path) {
  if (path.stroke && path.fill) return "B*\n";
  if (path.stroke) return "S\n";
  return path.fill ? "f*\n" : "n\n";
}

}  // namespace

void PdfContent::number(double value) {
  append_fixed(text_, value, k_decimals);
  text_ += ' ';
}

void PdfContent::numbers(std::initializer_list<double> values, std::string_view operation) {
  for (const double value : values)
    number(value);
  text_ += operation;
  text_ += '\n';
}

void PdfContent::color(Color color, std::string_view operation) {
  numbers({color.r / 255.0, color.g / 255.0, color.b / 255.0}, operation);
}

void PdfContent::add(std::span<const DrawingShape> shapes) {
  for (const DrawingShape& shape : shapes)
    std::visit([this](const auto& some) { add(some); }, shape);
}

void PdfContent::add_layers(std::span<const Layer> layers) {
  for (std::size_t i = 0; i < layers.size(); ++i) {
    text_ += "/OC /L" + std::to_string(i) + " BDC\n";
    add(layers[i].shapes);
    text_ += "EMC\n";
  }
}

void PdfContent::add_form(std::string_view name, Vec2 at, double scale) {
  text_ += "q\n";
  append_number(text_, scale);
  text_ += " 0 0 ";
  append_number(text_, scale);
  text_ += ' ';
  numbers({at.x, at.y}, "cm");
  text_ += '/';
  text_ += name;
  text_ += " Do\nQ\n";
}

void PdfContent::add_form_within(std::string_view name, Vec2 at, Vec2 low, Vec2 size) {
  text_ += "q\n";
  numbers({low.x, low.y, size.x, size.y}, "re");
  text_ += "W n\n";
  add_form(name, at, 1.0);
  text_ += "Q\n";
}

void PdfContent::add(const Path& path) {
  if (!path.stroke && !path.fill) return;
  if (path.fill) color(*path.fill, "rg");
  if (path.stroke) {
    const double width = path.stroke->width;
    color(path.stroke->color, "RG");
    numbers({width}, "w");
    text_ += '[';
    if (path.stroke->dashed) {
      number(12.0 * width);
      number(6.0 * width);
    }
    text_ += "] 0 d\n";
  }
  if (path.fitted.curves.empty()) {
    for (const auto& line : path.lines)
      add_line(line, path.closed);
  }
  for (const Curve& curve : path.fitted.curves)
    add_curve(curve, path.closed);
  text_ += painting(path);
}

void PdfContent::add_line(std::span<const Vec2> line, bool closed) {
  bool begun = false;
  for (const Vec2 place : whole_steps(line, k_steps, closed)) {
    numbers({place.x / k_steps, place.y / k_steps}, begun ? "l" : "m");
    begun = true;
  }
  if (begun && closed) text_ += "h\n";
}

void PdfContent::add_curve(const Curve& curve, bool closed) {
  if (curve.pieces.empty()) return;
  const auto add_cubic = [this](const CubicTo& cubic) {
    const auto& [first, second, end] = cubic;
    numbers({first.x, first.y, second.x, second.y, end.x, end.y}, "c");
  };
  numbers({curve.start.x, curve.start.y}, "m");
  Vec2 from = curve.start;
  for (const CurvePiece& piece : curve.pieces) {
    const Vec2 end = end_of(piece);
    if (const auto* cubic = std::get_if<CubicTo>(&piece)) {
      add_cubic(*cubic);
    } else if (const auto* arc = std::get_if<ArcTo>(&piece)) {
      for (const CubicTo& part : cubics_along(from, *arc))
        add_cubic(part);
    } else {
      numbers({end.x, end.y}, "l");
    }
    from = end;
  }
  if (closed) text_ += "h\n";
}

void PdfContent::add(const Text& text) {
  if (!std::isfinite(text.at.x) || !std::isfinite(text.at.y)) return;
  const auto letters = win_ansi(in_pdf_letters(text.text));
  if (!letters) {
    for (const Layer& layer : with_stroked_text({"", 0.0, 0.0, {Layer{"", {text}}}}).layers)
      add(layer.shapes);
    return;
  }
  const double size = text.height / k_helvetica_capital;
  const double left = text.centred ? 0.5 * size * helvetica_width(*letters) : 0.0;
  color(text.color, "rg");
  text_ += "BT\n/F1 ";
  numbers({size}, "Tf");
  numbers({text.at.x - left, text.at.y}, "Td");
  text_ += pdf_string(*letters) + " Tj\nET\n";
}

}  // namespace planish
