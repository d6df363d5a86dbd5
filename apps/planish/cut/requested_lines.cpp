#include "cut/requested_lines.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <limits>
#include <set>
#include <utility>

#include <planish/io/read_features.h>
#include <planish/mesh/carry.h>
#include <planish/mesh/geodesic.h>

#include "cut/drawn_on_pattern.h"
#include "cut/placed_lines.h"
#include "flags/quantities.h"
#include "flags/scale_flag.h"
#include "flags/units.h"
#include "platform/path.h"
#include "shell/text.h"
#include "text/lengths.h"

namespace planish::cli {

namespace {

/// Of the diagonal: vertices that are nearer to a plane count as on it.
constexpr double k_on_plane = 1e-6;

constexpr const char* k_open = "open";
constexpr const char* k_auto = "auto";

bool is_line(const std::string& value) {
  return value != k_open && value != k_auto;
}

std::vector<std::string> words_of(const std::string& text) {
  std::vector<std::string> words;
  std::string word;
  for (const char c : text + " ") {
    if (c != ' ') {
      word += c;
    } else if (!word.empty()) {
      words.push_back(std::exchange(word, {}));
    }
  }
  return words;
}

bool is_file(const std::string& text) {
  std::error_code ignored;
  return std::filesystem::exists(path_of(text), ignored);
}

bool is_numbers(const std::string& text) {
  return text.find_first_of("0123456789") != std::string::npos &&
         text.find_first_not_of("0123456789 ,\t") == std::string::npos;
}

/// The values in one that was given: with commas between them, but for those between numbers. A
/// file may have commas in its name.
std::vector<std::string> values_of(const std::string& text) {
  if (is_file(text) || is_numbers(text)) return {text};
  std::vector<std::string> values;
  std::size_t begin = 0;
  while (begin <= text.size()) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string part = text.substr(begin, end - begin);
    const std::vector<std::string> words = words_of(part);
    const bool goes_on = !values.empty() && !words.empty() && field_number(words.front());
    if (goes_on) {
      values.back() += "," + part;
    } else if (!words.empty()) {
      values.push_back(part);
    }
    begin = end + 1;
  }
  return values;
}

/// Lines of one value: each gets its number, where there are several.
void add(RequestedLines& all, std::vector<SurfaceLine> lines, const std::string& name) {
  for (std::size_t k = 0; k < lines.size(); ++k) {
    all.lines.push_back(std::move(lines[k]));
    all.names.push_back(name + (lines.size() > 1 ? " (" + std::to_string(k + 1) + ")" : ""));
    all.places.emplace_back();
  }
}

void add_lines(RequestedLines& all, CutLinesOnPatch read, const std::string& name) {
  for (std::size_t k = 0; k < read.lines.size(); ++k) {
    all.lines.push_back(std::move(read.lines[k]));
    all.places.push_back(read.places[k]);
    const auto line = read.places[k].line;
    all.names.push_back(name + (line ? ":" + std::to_string(*line) : ""));
  }
}

/// "; the mesh lies between y=-3.2 and y=10.4", in units of the file.
std::string extent_along(const Patch& patch, const Plane& plane, const Arguments& arguments) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const Vec3& p : as_in_file(patch.mesh(), arguments).positions) {
    low = std::min(low, dot(plane.normal, p));
    high = std::max(high, dot(plane.normal, p));
  }
  const std::string axis = plane.normal.x != 0.0 ? "x=" : plane.normal.y != 0.0 ? "y=" : "z=";
  return "; the mesh lies between " + axis + digits(low, 4) + " and " + axis + digits(high, 4);
}

void add_section(RequestedLines& all, const Patch& patch, const LineWords& asked,
                 const Arguments& arguments) {
  const auto plane =
      axis_plane("--cut", "plane ", asked.words.size() == 2 ? asked.words[1] : "", arguments);
  auto lines = plane_section(patch, plane, k_on_plane * bounding_box_diagonal(patch.mesh()));
  if (lines.empty()) {
    throw Error(ErrorCode::misplaced_cut, "--cut " + asked.value +
                                              ": the plane does not meet the mesh" +
                                              extent_along(patch, plane, arguments));
  }
  add(all, std::move(lines), asked.value);
}

void add_creases(RequestedLines& all, const Patch& patch, const LineWords& asked,
                 const Arguments& arguments) {
  const std::string angle = asked.words.size() > 1 ? asked.words[1] : "30deg";
  const double least = quantity_value("--cut creases", angle, Quantity::angle,
                                      {.min = 1.0, .max = 180.0}, arguments);
  auto lines = crease_lines(patch, least);
  if (lines.empty()) {
    throw Error(ErrorCode::misplaced_cut, "--cut " + asked.value + ": the mesh has no creases of " +
                                              angle + "; give a smaller angle");
  }
  add(all, std::move(lines), asked.value);
}

void add_rings(RequestedLines& all, const Patch& patch) {
  std::vector<SurfaceLine> lines;
  for (GeodesicPath& ring : narrow_rings(patch))
    lines.push_back(std::move(ring.points));
  if (lines.empty()) {
    throw Error(ErrorCode::misplaced_cut,
                "--cut rings: the surface is nowhere narrower than on both sides; name a place, as "
                "in \"ring 0,0,1\"");
  }
  all.notes.push_back("--cut rings: found " + counted(lines.size(), "narrow ring"));
  add(all, std::move(lines), "rings");
}

void add_listed(RequestedLines& all, const Patch& patch, const std::string& numbers,
                const std::string& name) {
  add(all, cut_lines_in(parse_rows(numbers, "--cut " + name), patch).lines, name);
}

/// Edges that the model's file sets apart.
void add_model_lines(RequestedLines& all, const Patch& patch, const std::string& path,
                     const LineWords& asked) {
  const std::string& kind = asked.words.front();
  const ModelLines which = kind == "uv"       ? ModelLines::texture
                           : kind == "groups" ? ModelLines::groups
                                              : ModelLines::materials;
  DrawnLines drawn = read_model_lines(path_of(path), which);
  // Edges of what is left out of the file are passed over.
  const auto row = [](Vec3 p) { return std::array{p.x, p.y, p.z}; };
  std::set<std::array<double, 3>> places;
  for (const Vec3 p : patch.positions())
    places.insert(row(p));
  std::erase_if(drawn.lines, [&](const DrawnLine& line) {
    return !places.contains(row(line.points.front())) || !places.contains(row(line.points.back()));
  });
  std::vector<SurfaceLine> lines =
      trace_lines(patch, {chained_lines(std::move(drawn.lines)), {}}).lines;
  if (lines.empty()) {
    throw Error(ErrorCode::misplaced_cut,
                "--cut " + kind + ": none of these edges is one of the mesh that is cut");
  }
  all.notes.push_back("--cut " + kind + ": " + counted(lines.size(), "line"));
  add(all, std::move(lines), kind);
}

void add_file(RequestedLines& all, const Patch& patch, const std::string& file,
              const Arguments& arguments) {
  const bool smooth = arguments.text("--smooth-lines", "yes") != "no";
  const auto kept = arguments.files.find(file);
  CutLinesOnPatch read = kept != arguments.files.end()
                             ? parse_cut_lines(kept->second, patch, file, smooth)
                             : read_cut_lines(path_of(file), patch, smooth);
  const ShownLengths lengths(unit_from(arguments));
  const double scale = scale_from(arguments);
  if (read.farthest > 0.0) {
    all.notes.push_back(file + ": what is drawn is at most " + lengths.text(scale * read.farthest) +
                        " from the surface");
  }
  add_lines(all, std::move(read), file);
}

/// What was added to a pattern.
void add_pattern_lines(RequestedLines& all, const Patch& patch, const std::string& file,
                       const Arguments& arguments) {
  const Patch flat = pattern_below(file, patch, scale_from(arguments));
  const ReadDrawing read = drawing_on_sheet(file, flat, unit_from(arguments));
  // Line by line, as each may leave the pattern.
  for (const DrawnLine& line : chained_lines(read.drawn.lines)) {
    for (SurfaceLine& part : trace_lines(flat, {{line}, {}}).lines) {
      all.lines.push_back(std::move(part));
      all.names.push_back(file + (line.place.line ? ":" + std::to_string(*line.place.line) : ""));
      all.places.push_back(line.place);
    }
  }
  if (all.lines.empty()) {
    throw Error(ErrorCode::misplaced_cut, "no line of the drawing lies on the pattern",
                {.path = file});
  }
}

void add_words(RequestedLines& all, const Patch& patch, const std::string& path,
               const LineWords& asked, const Arguments& arguments) {
  const std::string& kind = asked.words.front();
  if (kind == "plane") {
    add_section(all, patch, asked, arguments);
  } else if (kind == "creases") {
    add_creases(all, patch, asked, arguments);
  } else if (kind == "line") {
    add(all, {shortest_line(patch, asked, arguments)}, asked.value);
  } else if (kind == "straight") {
    add(all, {straight_line(patch, asked, arguments)}, asked.value);
  } else if (kind == "ring") {
    add(all, {ring_line(patch, asked, arguments)}, asked.value);
  } else if (kind == "rings") {
    add_rings(all, patch);
  } else if (kind == "vertices") {
    add_listed(all, patch, asked.value.substr(asked.value.find(kind) + kind.size()), asked.value);
  } else if (kind == "uv" || kind == "groups" || kind == "materials") {
    add_model_lines(all, patch, path, asked);
  } else if (is_numbers(asked.value)) {
    add_listed(all, patch, asked.value, asked.value);
  } else {
    add_file(all, patch, asked.value, arguments);
  }
}

/// Those of all times that the flag is given.
std::vector<std::string> all_values(const Arguments& arguments) {
  std::vector<std::string> all;
  for (const Field& given : arguments.flags.at("--cut")) {
    for (std::string& value : values_of(field_text(given)))
      all.push_back(std::move(value));
  }
  return all;
}

bool has_value(const Arguments& arguments, const char* word) {
  if (!arguments.has("--cut") || arguments.rows.contains("--cut")) return false;
  const std::vector<std::string> values = all_values(arguments);
  return std::find(values.begin(), values.end(), word) != values.end();
}

}  // namespace

bool asks_to_open(const Arguments& arguments) {
  return has_value(arguments, k_open);
}

bool asks_for_panels(const Arguments& arguments) {
  return has_value(arguments, k_auto);
}

bool asks_for_lines(const Arguments& arguments) {
  if (!arguments.has("--cut")) return false;
  if (arguments.rows.contains("--cut")) return true;
  const std::vector<std::string> values = all_values(arguments);
  return std::any_of(values.begin(), values.end(), is_line);
}

RequestedLines requested_lines(const Patch& patch, const std::string& path,
                               const Arguments& arguments) {
  RequestedLines all;
  if (arguments.rows.contains("--cut")) {
    add_lines(all, cut_lines_in(arguments.rows_of("--cut"), patch), "cut");
    return all;
  }
  for (const std::string& value : all_values(arguments)) {
    if (!is_line(value)) continue;
    if (!is_file(value)) {
      add_words(all, patch, path, {value, words_of(value)}, arguments);
    } else if (is_svg(value)) {
      add_pattern_lines(all, patch, value, arguments);
    } else {
      add_file(all, patch, value, arguments);
    }
  }
  return all;
}

}  // namespace planish::cli
