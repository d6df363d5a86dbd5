#include "output/pattern_notes.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>
#include <set>
#include <string_view>
#include <system_error>

#include "draw/pdf/pdf_text.h"
#include "draw/text/ascii_text.h"
#include "draw/text/stroke_text.h"
#include "platform/path.h"
#include "shell/session.h"
#include "shell/values.h"

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

/// 0 of what is no PDF.
int pages_in(std::string_view pdf) {
  constexpr std::string_view before = "/Type /Pages /Count ";
  const std::size_t at = pdf.find(before);
  if (at == std::string_view::npos) return 0;
  return std::atoi(std::string(pdf.substr(at + before.size(), 10)).c_str());
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

}  // namespace

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
        output.paper &&
        utf8_of(file.path.stem()).ends_with("-" + std::string(to_string(*output.paper)));
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

}  // namespace planish::cli
