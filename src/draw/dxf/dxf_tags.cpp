#include "draw/dxf/dxf_tags.h"

#include "core/number_text.h"
#include "draw/hex.h"
#include "draw/text/utf8.h"

namespace planish {

namespace {

constexpr double k_text_height = 3.0;  // that programs begin with, millimetres

void append_escaped(std::string& text, char32_t value) {
  for (const char16_t unit : utf16_units(value)) {
    text += "\\U+";
    append_hex(text, unit, 4);
  }
}

bool is_name_letter(char32_t c) {
  return (c >= U'A' && c <= U'Z') || (c >= U'a' && c <= U'z') || (c >= U'0' && c <= U'9') ||
         c == U'$' || c == U'-' || c == U'_';
}

}  // namespace

void DxfTags::add(int code, std::string_view value) {
  text_ += std::to_string(code);
  text_ += '\n';
  text_ += value;
  text_ += '\n';
}

void DxfTags::add(int code, int value) {
  add(code, std::to_string(value));
}

void DxfTags::add_real(int code, double value) {
  std::string number = fixed_text(value, 3);
  if (number.find('.') == std::string::npos) number += ".0";
  add(code, number);
}

void DxfTags::add_point(int code, Vec2 place) {
  add_real(code, place.x);
  add_real(code + 10, place.y);
  add_real(code + 20, 0.0);
}

void DxfTags::begin_section(std::string_view name) {
  add(0, "SECTION");
  add(2, name);
}

void DxfTags::end_section() {
  add(0, "ENDSEC");
}

void DxfTags::add_point_entity(std::string_view layer, Vec2 place, double height) {
  add(0, "POINT");
  add(8, layer);
  add_real(10, place.x);
  add_real(20, place.y);
  add_real(30, height);
}

void DxfTags::add_text(std::string_view layer, Vec2 at, double height, std::string_view text) {
  add(0, "TEXT");
  add(8, layer);
  add_point(10, at);
  add_real(40, height);
  add(1, dxf_text(text));
}

void DxfTags::add_words(const Text& text) {
  add_point(10, text.at);
  add_real(40, text.height);
  add(1, dxf_text(text.text));
  if (!text.centred) return;
  add(72, 1);
  add_point(11, text.at);
}

void DxfTags::add_text_style() {
  add(70, 0);
  add_real(40, 0.0);  // no height of its own
  add_real(41, 1.0);
  add_real(50, 0.0);
  add(71, 0);
  add_real(42, k_text_height);
  add(3, "txt");
  add(4, "");
}

void DxfTags::add_polyline(std::string_view layer, std::span<const Vec2> places, bool closed,
                           const DxfTags& looks) {
  add(0, "POLYLINE");
  add(8, layer);
  append(looks);
  add(66, 1);  // vertices follow
  add_point(10, {});
  add(70, closed ? 1 : 0);
  for (const Vec2 place : places) {
    add(0, "VERTEX");
    add(8, layer);
    add_point(10, place);
  }
  add(0, "SEQEND");
  add(8, layer);
}

std::string dxf_text(std::string_view text) {
  const std::u32string points = code_points(text);
  std::string escaped;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const char32_t point = points[i];
    const bool is_doubled =
        (i > 0 && points[i - 1] == point) || (i + 1 < points.size() && points[i + 1] == point);
    // %% and ^ begin codes of AutoCAD's own, and the backslash that of these escapes.
    const bool has_meaning = point == U'\\' || point == U'^' || (point == U'%' && is_doubled);
    if (point < U' ' || point == 0x7F) {
      escaped += ' ';
    } else if (point < 0x7F && !has_meaning) {
      escaped += static_cast<char>(point);
    } else {
      append_escaped(escaped, point);
    }
  }
  return escaped;
}

std::string dxf_name(std::string_view name) {
  std::string allowed;
  for (const char32_t point : code_points(name)) {
    if (allowed.size() == k_longest_dxf_name) break;
    allowed += is_name_letter(point) ? static_cast<char>(point) : '_';
  }
  return allowed.empty() ? "_" : allowed;
}

}  // namespace planish
