#pragma once

// The lines that files of drawings hold, read as their formats define them; throws where a file is
// not well-formed. Millimetres.

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <planish/core/vec.h>

#include "oracle/read_xml.h"

namespace planish::oracle {

using Lines = std::vector<std::vector<Vec2>>;

inline double number_in(std::string_view text) {
  double value = 0.0;
  const auto parsed = std::from_chars(text.data(), text.data() + text.size(), value);
  if (parsed.ec != std::errc() || parsed.ptr != text.data() + text.size())
    throw std::runtime_error("no number: " + std::string(text.substr(0, 40)));
  return value;
}

/// Takes the text up to one of the marks off the front, and the mark.
inline std::string_view take_to(std::string_view& text, std::string_view marks) {
  const std::size_t end = text.find_first_of(marks);
  const std::string_view taken = text.substr(0, end);
  text.remove_prefix(end == text.npos ? text.size() : end + 1);
  return taken;
}

/// M, l, L, C, A and z of an SVG path. Of curves the control points, of arcs the ends.
inline Lines lines_of_svg_path(std::string_view d) {
  constexpr std::string_view commands = "MlLCAz";
  Lines lines;
  Vec2 pen;
  char command = 0;
  while (!d.empty()) {
    if (commands.find(d.front()) != commands.npos) {
      command = d.front();
      d.remove_prefix(1);
    } else if (d.front() == ' ') {
      d.remove_prefix(1);
    }
    if (command == 'M') lines.emplace_back();
    if (lines.empty()) throw std::runtime_error("SVG: a path does not begin with M");
    if (command == 'z') {
      std::vector<Vec2>& line = lines.back();
      if (!(line.back() == line.front()) || line.size() == 1) line.push_back(line.front());
      continue;
    }
    if (command == 'A') {
      for (int k = 0; k < 4; ++k)  // radii, angle, and which of four arcs
        take_to(d, " ");
    }
    const double x = number_in(take_to(d, ","));
    const std::size_t end = d.find_first_of("MlLCAz ");
    const double y = number_in(d.substr(0, end));
    d.remove_prefix(std::min(end, d.size()));
    pen = command == 'l' ? pen + Vec2{x, y} : Vec2{x, y};
    lines.back().push_back(pen);
  }
  return lines;
}

inline Lines lines_of_svg(std::string_view svg) {
  Lines all;
  for (const XmlElement& element : XmlReader(svg).elements()) {
    if (element.name != "path") continue;
    for (auto& line : lines_of_svg_path(element.attributes.at("d")))
      all.push_back(std::move(line));
  }
  return all;
}

using DxfTagList = std::vector<std::pair<int, std::string_view>>;

/// Group codes and values, two lines each, and sections that begin and end.
inline DxfTagList tags_of_dxf(std::string_view dxf) {
  DxfTagList tags;
  bool in_section = false;
  while (!dxf.empty()) {
    const auto code = static_cast<int>(number_in(take_to(dxf, "\n")));
    tags.emplace_back(code, take_to(dxf, "\n"));
    const std::string_view value = tags.back().second;
    if (code != 0) continue;
    if (value == "SECTION" || value == "ENDSEC") {
      if (in_section == (value == "SECTION")) throw std::runtime_error("DXF: sections nest");
      in_section = !in_section;
    }
  }
  if (in_section || tags.empty() || tags.back().second != "EOF")
    throw std::runtime_error("DXF: ends early");
  return tags;
}

inline Lines lines_of_dxf(std::string_view dxf) {
  Lines lines;
  std::string_view entity;
  bool closed = false;
  for (const auto& [code, value] : tags_of_dxf(dxf)) {
    if (code == 0) {
      entity = value;
      if (entity == "POLYLINE") lines.emplace_back();
      if (entity == "SEQEND" && closed) lines.back().push_back(lines.back().front());
    }
    if (entity == "POLYLINE" && code == 70) closed = value == "1";
    if (entity == "VERTEX" && code == 10) lines.back().push_back({number_in(value), 0.0});
    if (entity == "VERTEX" && code == 20) lines.back().back().y = number_in(value);
  }
  return lines;
}

/// PU moves, PD draws; 40 units a millimetre.
inline Lines lines_of_plt(std::string_view plt) {
  Lines lines;
  while (!plt.empty()) {
    std::string_view instruction = take_to(plt, ";");
    if (plt.starts_with('\n')) plt.remove_prefix(1);
    const std::string_view name = instruction.substr(0, 2);
    instruction.remove_prefix(name.size());
    if (name == "IN" || name == "SP") continue;
    if (name != "PU" && name != "PD") throw std::runtime_error("HPGL: unknown instruction");
    if (name == "PU" && !instruction.empty()) lines.emplace_back();
    while (!instruction.empty()) {
      const double x = number_in(take_to(instruction, ","));
      if (lines.empty()) throw std::runtime_error("HPGL: the pen begins nowhere");
      lines.back().push_back({x / 40.0, number_in(take_to(instruction, ",")) / 40.0});
    }
  }
  return lines;
}

/// Checks that a PDF's table tells where its objects are and its streams how long they are.
inline void check_pdf(std::string_view pdf) {
  const auto require = [](bool holds, const char* fault) {
    if (!holds) throw std::runtime_error(std::string("PDF: ") + fault);
  };
  require(pdf.starts_with("%PDF-1.") && pdf.ends_with("\n%%EOF\n"), "begins or ends otherwise");
  const std::size_t start = pdf.rfind("startxref\n");
  require(start != pdf.npos, "no startxref");
  std::string_view place = pdf.substr(start + 10);
  std::string_view table = pdf.substr(static_cast<std::size_t>(number_in(take_to(place, "\n"))));
  require(take_to(table, "\n") == "xref", "startxref leads elsewhere");
  take_to(table, " ");
  const auto size = static_cast<std::size_t>(number_in(take_to(table, "\n")));
  for (std::size_t k = 0; k < size; ++k, table.remove_prefix(20)) {
    if (k == 0) continue;
    std::string_view object =
        pdf.substr(std::strtoull(std::string(table.substr(0, 10)).c_str(), nullptr, 10));
    require(object.starts_with(std::to_string(k) + " 0 obj\n"), "the table is wrong");
    constexpr std::string_view length = "obj\n<< /Length ";
    const std::size_t at = object.find(length);
    if (at > 12) continue;  // no stream
    object.remove_prefix(at + length.size());
    const auto bytes = static_cast<std::size_t>(number_in(take_to(object, " ")));
    const std::size_t data = object.find("stream\n") + 7;
    require(object.substr(data + bytes).starts_with("\nendstream"), "a length is wrong");
  }
}

inline double length_of(const Lines& lines) {
  double length = 0.0;
  for (const auto& line : lines) {
    for (std::size_t i = 1; i < line.size(); ++i)
      length += norm(line[i] - line[i - 1]);
  }
  return length;
}

}  // namespace planish::oracle
