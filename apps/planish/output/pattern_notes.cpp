#include "output/pattern_notes.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>
#include <set>
#include <system_error>

#include "draw/pdf/pdf_text.h"
#include "draw/text/ascii_text.h"
#include "draw/text/stroke_text.h"
#include "platform/path.h"
#include "shell/session.h"
#include "shell/text.h"
#include "shell/values.h"
#include "text/lengths.h"

namespace planish::cli {

namespace {

namespace fs = std::filesystem;

std::string spelled_in(PatternFormat format, const std::string& word, const PatternOutput& output) {
  const bool is_apparel = format == PatternFormat::dxf && output.dxf.profile != DxfProfile::generic;
  // Accents that apparel programs do without are no news.
  if (is_apparel) return in_stroke_letters(word) == word ? word : ascii_text(word);
  if (output.stroked_text || format == PatternFormat::plt) return in_stroke_letters(word);
  return format == PatternFormat::pdf ? in_pdf_letters(word) : word;
}

/// "layout-2.pdf": what a drawing of `flatten` is called.
bool is_our_drawing(const fs::path& path) {
  constexpr std::array<std::string_view, 4> k_stems = {"pattern", "as-designed", "layout",
                                                       "garment"};
  if (!pattern_format_of(utf8_of(path.filename()))) return false;
  const std::string stem = utf8_of(path.stem());
  return std::any_of(k_stems.begin(), k_stems.end(), [&](std::string_view start) {
    return stem == start || (stem.starts_with(start) && stem[start.size()] == '-');
  });
}

/// Whether it is the folder of a piece: --resume reads its job.json.
bool is_our_folder(const fs::path& path) {
  std::error_code failure;
  return fs::is_regular_file(path / path_of("job.json"), failure);
}

/// Where --only-layers has what is cut but for the holes.
void note_holes_left_out(Session& session, const Drawing& drawing, const PatternOutput& output) {
  const auto has = [&](const std::string& name) {
    return std::find(output.only_layers.begin(), output.only_layers.end(), name) !=
           output.only_layers.end();
  };
  const bool has_holes =
      std::any_of(drawing.layers.begin(), drawing.layers.end(),
                  [](const Layer& layer) { return layer.name == "hole" && !layer.shapes.empty(); });
  if (has_holes && has("cut") && !has("hole"))
    session.note("--only-layers: holes are on a layer of their own: cut,hole has all that is cut");
}

}  // namespace

int pages_in(std::string_view pdf) {
  constexpr std::string_view before = "/Type /Pages /Count ";
  const std::size_t at = pdf.find(before);
  if (at == std::string_view::npos) return 0;
  return std::atoi(std::string(pdf.substr(at + before.size(), 10)).c_str());
}

std::vector<std::string> words_of(const std::string& name, const PieceLabel& label) {
  return {name, label.name, label.size, label.fabric, label.note};
}

void note_spelling(Session& session, const std::vector<std::string>& words,
                   const std::vector<PatternFormat>& formats, const PatternOutput& output) {
  for (const std::string& word : std::set<std::string>(words.begin(), words.end())) {
    std::map<std::string, std::string> spellings;  // -> the formats
    for (const PatternFormat format : formats) {
      const std::string spelling = spelled_in(format, word, output);
      if (spelling == word) continue;
      std::string& where = spellings[spelling];
      where += (where.empty() ? "." : ", .") + std::string(to_string(format));
    }
    for (const auto& [spelling, where] : spellings) {
      session.note(
          "\"" + word + "\" is written as \"" + spelling + "\" in " + where +
          ", as there are Latin letters only" +
          (output.stroked_text ? "" : "; .svg, and .dxf of the profile generic, have all letters"));
    }
  }
}

void note_empty_layers(Session& session, const Drawing& drawing, const PatternOutput& output) {
  if (!output.layers_by_name) return;
  note_holes_left_out(session, drawing, output);
  std::vector<std::string> empty, there;
  for (const Layer& layer : drawing.layers) {
    const bool is_map = layer.name == "strain" || layer.name == "legend";
    if (layer.shapes.empty() || (is_map && !output.map)) continue;
    there.push_back(layer.name);
  }
  for (const std::string& name : output.only_layers) {
    // The label of pieces is drawn on their sheets only.
    const bool is_there = name == "label" || name == "strain" || name == "legend" ||
                          std::find(there.begin(), there.end(), name) != there.end();
    if (!is_there) empty.push_back(name);
  }
  if (empty.empty()) return;
  session.note("--only-layers: the drawing has nothing on " + list_of_some(empty) + ", only on " +
               list_of_some(there));
}

void note_divided_pages(Session& session, const std::vector<OutputFile>& files,
                        const PatternOutput& output) {
  for (const OutputFile& file : files) {
    if (pattern_format_of(utf8_of(file.path)) != PatternFormat::pdf) continue;
    const bool is_asked =
        output.pages && utf8_of(file.path.stem()).ends_with("-" + output.pages->paper.name);
    const int pages = pages_in(file.content);
    if (is_asked) continue;
    if (pages > 1) {
      session.note(utf8_of(file.path) + " is divided into " + std::to_string(pages - 1) +
                   " pages to join, as many viewers show pages longer than 5.08 m too small");
    } else if (file.content.find(" /UserUnit ") != std::string::npos) {
      session.note(utf8_of(file.path) +
                   " has a page of more than 5.08 m, which many viewers show too small: take .dxf");
    }
  }
}

std::vector<std::string> left_of_earlier_runs(const fs::path& folder,
                                              std::span<const fs::path> written) {
  const auto normal = [](const fs::path& path) { return (path / "").lexically_normal(); };
  std::set<std::string> ours;
  for (const fs::path& path : written) {
    if (normal(path.parent_path()) == normal(folder)) ours.insert(utf8_of(path.filename()));
  }
  std::vector<std::string> names;
  std::error_code failure;
  for (const fs::path& entry : entries_of(folder, failure)) {
    const std::string name = utf8_of(entry.filename());
    if (ours.contains(name)) continue;
    if (is_our_drawing(entry) || is_our_folder(entry)) names.push_back(name);
  }
  std::sort(names.begin(), names.end());
  return names;
}

void warn_of_left(Session& session, const fs::path& folder, const std::vector<std::string>& names) {
  if (names.empty()) return;
  session.warn(utf8_of(folder) + " still has " + list_of_some(names) +
               " of an earlier run: these are not of this pattern");
}

namespace {

/// Where a pattern overlaps itself, from its lower left corner; empty where that is not known.
std::string overlap_text(const UnfoldReport& report) {
  const auto& overlap = report.overlap;
  if (!overlap) return {};
  const ShownLengths lengths(report.unit);
  const Vec2 middle = 0.5 * (overlap->low + overlap->high);
  // Crossings that lie on one line make a box without a width.
  const double least = 0.005 / millimetres_per(report.unit);
  const auto extent = [&](double low, double high) {
    return high - low < least ? 0.0 : high - low;
  };
  return " around (" + lengths.number(middle.x) + ", " + lengths.text(middle.y) + ") over " +
         lengths.number(extent(overlap->low.x, overlap->high.x)) + " x " +
         lengths.text(extent(overlap->low.y, overlap->high.y)) +
         ", where its border crosses itself " + counted(overlap->crossings, "time");
}

/// Of a border that crossed itself by a hair.
std::string opened_text(const UnfoldReport& report) {
  const OpenedCrossings& opened = *report.pattern.opened;
  const ShownLengths lengths(report.unit);
  const Vec2 place = report.pattern.positions[opened.vertex];
  return "the border of the pattern crossed itself by less than 0.1 mm, " +
         counted(opened.crossings, "time") + ": vertices were moved apart by up to " +
         lengths.text(opened.largest_move) + ", most at (" + lengths.number(place.x) + ", " +
         lengths.text(place.y) + ")";
}

std::string holes_text(const PatternHoles& holes, Unit unit) {
  const ShownLengths lengths(unit);
  constexpr double k_enough = 1.01;  // more than the digits that are shown leave out
  std::string enough = lengths.text(k_enough * holes.longest);  // as a flag takes it
  std::erase(enough, ' ');
  const bool is_one = holes.count == 1;
  return "the patch has " + counted(holes.count, "hole") + ", which " +
         (is_one ? "stays" : "stay") + "; the longest border of one is " +
         lengths.text(holes.longest) + ". If " + (is_one ? "it is" : "they are") +
         " not meant, --fill-holes " + enough + " closes " + (is_one ? "it" : "them");
}

}  // namespace

void note_plotter_reach(Session& session, const UnfoldReport& report) {
  constexpr double k_reach = 32767.0 / 40.0;  // millimetres, of 16-bit coordinates
  const Pattern& pattern = report.pattern;
  if (millimetres_per(report.unit) * std::max(pattern.width, pattern.height) <= k_reach) return;
  session.note(
      "the .plt file reaches beyond 819 mm: plotters whose coordinates have 16 bits cut the "
      "drawing "
      "off there");
}

void warn_of_pattern(Session& session, const UnfoldReport& report, bool is_unit_given) {
  const Pattern& pattern = report.pattern;
  if (pattern.overlaps) {
    session.warn("the pattern overlaps itself" + overlap_text(report) +
                 ": cut the patch open before cutting material");
  }
  if (pattern.opened) session.note(opened_text(report));
  if (pattern.holes) session.note(holes_text(*pattern.holes, report.unit));
  if (pattern.flipped_triangles > 0) {
    session.warn(counted(pattern.flipped_triangles, "triangle") +
                 " of the pattern are flipped over: do not cut it");
  }
  if (!pattern.converged) {
    session.warn(
        "laying flat ended before it converged: the pattern may be stretched more than need be");
  }
  if (is_unit_given) return;
  if (const auto size = unusual_size_text(pattern, report.unit)) session.note(*size);
}

}  // namespace planish::cli
