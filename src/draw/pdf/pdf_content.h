#pragma once

#include <initializer_list>
#include <span>
#include <string>
#include <string_view>

#include <planish/draw/drawing.h>

namespace planish {

/// A content stream in millimetres, y up. Text uses a font called F1.
class PdfContent {
 public:
  void add(const Path& path);
  void add(const Text& text);
  /// The shapes of all layers; the i-th is marked as the optional content Li.
  void add_layers(std::span<const Layer> layers);
  /// Draws the form called `name` with its (0, 0) at `at`.
  void add_form(std::string_view name, Vec2 at, double scale);
  /// The same, as far as it lies within a rectangle.
  void add_form_within(std::string_view name, Vec2 at, Vec2 low, Vec2 size);

  const std::string& text() const { return text_; }

 private:
  void add(std::span<const DrawingShape> shapes);
  void add_line(std::span<const Vec2> line, bool closed);
  void add_curve(const Curve& curve, bool closed);
  void number(double value);
  void numbers(std::initializer_list<double> values, std::string_view operation);
  void color(Color color, std::string_view operation);

  std::string text_;
};

}  // namespace planish
