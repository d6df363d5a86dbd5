#include "cut/requested_lines.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>
#include <utility>

#include <planish/io/read_features.h>

#include "flags/quantities.h"
#include "flags/scale_flag.h"
#include "flags/units.h"
#include "platform/path.h"
#include "shell/failures.h"
#include "text/lengths.h"

namespace planish::cli {

namespace {

/// Of the diagonal: vertices that are nearer to a plane count as on it.
constexpr double k_on_plane = 1e-6;

constexpr const char* k_open = "open";

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

/// The values of the flag: one where it is a file with commas in its name.
std::vector<std::string> values_of(const std::string& text) {
  if (is_file(text)) return {text};
  std::vector<std::string> values;
  std::size_t begin = 0;
  while (begin <= text.size()) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    if (end > begin) values.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return values;
}

/// "x=0", "y=12mm"
Plane plane_of(const std::string& value, const std::vector<std::string>& words,
               const Arguments& arguments) {
  const std::string text = words.size() == 2 ? words[1] : "";
  const auto axis = std::string_view("xyz").find(text.empty() ? '?' : text[0]);
  if (axis == std::string_view::npos || text.size() < 3 || text[1] != '=') {
    throw UsageError("--cut " + value + ": a plane is \"plane x=0\", \"plane y=12mm\" or with z");
  }
  const double offset =
      quantity_value("--cut plane", text.substr(2), Quantity::length, {}, arguments);
  constexpr std::array axes = {Vec3{1.0, 0.0, 0.0}, Vec3{0.0, 1.0, 0.0}, Vec3{0.0, 0.0, 1.0}};
  return {axes[axis], offset / scale_from(arguments)};
}

void add(RequestedLines& all, std::vector<SurfaceLine> lines, const std::string& name) {
  for (SurfaceLine& line : lines) {
    all.lines.push_back(std::move(line));
    all.names.push_back(name);
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

void add_section(RequestedLines& all, const Patch& patch, const std::string& value,
                 const std::vector<std::string>& words, const Arguments& arguments) {
  auto lines = plane_section(patch, plane_of(value, words, arguments),
                             k_on_plane * bounding_box_diagonal(patch.mesh()));
  if (lines.empty())
    throw Error(ErrorCode::misplaced_cut, "--cut " + value + ": the plane does not meet the mesh");
  add(all, std::move(lines), value);
}

void add_creases(RequestedLines& all, const Patch& patch, const std::string& value,
                 const std::vector<std::string>& words, const Arguments& arguments) {
  const std::string angle = words.size() > 1 ? words[1] : "30deg";
  const double least = quantity_value("--cut creases", angle, Quantity::angle,
                                      {.min = 1.0, .max = 180.0}, arguments);
  auto lines = crease_lines(patch, least);
  if (lines.empty()) {
    throw Error(ErrorCode::misplaced_cut, "--cut " + value + ": the mesh has no creases of " +
                                              angle + "; give a smaller angle");
  }
  add(all, std::move(lines), value);
}

void add_file(RequestedLines& all, const Patch& patch, const std::string& file,
              const Arguments& arguments) {
  CutLinesOnPatch read =
      read_cut_lines(path_of(file), patch, arguments.text("--smooth-lines", "yes") != "no");
  const ShownLengths lengths(unit_from(arguments));
  const double scale = scale_from(arguments);
  if (read.farthest > 0.0) {
    all.notes.push_back(file + ": what is drawn is at most " + lengths.text(scale * read.farthest) +
                        " from the surface");
  }
  add_lines(all, std::move(read), file);
}

}  // namespace

bool asks_to_open(const Arguments& arguments) {
  if (arguments.rows.contains("--cut")) return false;
  const std::vector<std::string> values = values_of(arguments.text("--cut"));
  return std::find(values.begin(), values.end(), k_open) != values.end();
}

bool asks_for_lines(const Arguments& arguments) {
  if (arguments.rows.contains("--cut")) return true;
  const std::vector<std::string> values = values_of(arguments.text("--cut"));
  return std::any_of(values.begin(), values.end(),
                     [](const std::string& value) { return value != k_open; });
}

RequestedLines requested_lines(const Patch& patch, const Arguments& arguments) {
  RequestedLines all;
  if (arguments.rows.contains("--cut")) {
    add_lines(all, cut_lines_in(arguments.rows_of("--cut"), patch), "cut");
    return all;
  }
  for (const std::string& value : values_of(arguments.text("--cut"))) {
    if (value == k_open) continue;
    const std::vector<std::string> words =
        is_file(value) ? std::vector<std::string>{} : words_of(value);
    const std::string kind = words.empty() ? "" : words[0];
    if (kind == "plane") {
      add_section(all, patch, value, words, arguments);
    } else if (kind == "creases") {
      add_creases(all, patch, value, words, arguments);
    } else {
      add_file(all, patch, value, arguments);
    }
  }
  return all;
}

}  // namespace planish::cli
