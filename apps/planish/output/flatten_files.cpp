#include "output/flatten_files.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
#include <string_view>
#include <utility>

#include <planish/draw/drawing.h>
#include <planish/sheet/pattern_sheet.h>

#include "flags/annotation_flags.h"
#include "flags/fields_flag.h"
#include "flatten/reference_sweeps.h"
#include "platform/path.h"

namespace planish::cli {

namespace {

namespace fs = std::filesystem;

/// The pattern of the result, and where that may be another one that of the design.
std::vector<OutputFile> pattern_files(const FlattenReport& report, const Drawing& sheet,
                                      const WrittenFiles& paths, const PatternFiles& pattern) {
  std::optional<Drawing> as_designed;
  if (report.evolve.method) {
    PatternOptions annotations = on_processed(pattern.annotations, report);
    annotations.moved.reset();
    annotations.form_faults.clear();
    as_designed = pattern_sheet(report.input, report.design_pattern, report.name + ", as designed",
                                annotations);
  }
  std::vector<OutputFile> files;
  files.reserve(2 * pattern.formats.size() + 1);
  for (const PatternFormat format : pattern.formats) {
    files.push_back({path_of(paths.at(role_of("pattern", format))),
                     pattern_file(sheet, format, pattern.output)});
    if (as_designed) {
      files.push_back({path_of(paths.at(role_of("as_designed", format))),
                       pattern_file(*as_designed, format, pattern.output)});
    }
  }
  if (pattern.output.pages) {
    files.push_back({path_of(paths.at("pattern_pages")), tiled_file(sheet, pattern.output)});
  }
  return files;
}

/// Those with the pattern, as the page names them.
std::vector<PageFile> files_beside_page(const WrittenFiles& paths) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 5> k_purposes = {
      {{"pattern_pdf", "to print at 100 %"},
       {"pattern_pages", "on pages to join, at 100 %"},
       {"pattern", "for cutters and drawing programs"},
       {"pattern_dxf", "for CAD"},
       {"pattern_plt", "for plotters"}}};
  std::vector<PageFile> files;
  for (const auto& [role, purpose] : k_purposes) {
    const auto found = paths.find(std::string(role));
    if (found != paths.end())
      files.push_back({utf8_of(path_of(found->second).filename()), std::string(purpose)});
  }
  return files;
}

}  // namespace

std::string role_of(const std::string& pattern, PatternFormat format) {
  return pattern + (format == PatternFormat::svg ? "" : "_" + std::string(to_string(format)));
}

PatternFiles pattern_files_from(const Arguments& arguments) {
  PatternFiles pattern = {formats_from(arguments), pattern_output_from(arguments),
                          annotations_from(arguments, true)};
  std::vector<PatternFormat> written = pattern.formats;
  if (pattern.output.pages) written.push_back(PatternFormat::pdf);
  refuse_idle_pattern_flags(arguments, written);
  return pattern;
}

DrawnPattern drawn_pattern(const FlattenReport& report, const PatternOptions& annotations) {
  PatternGeometry geometry = pattern_geometry(report, annotations);
  const TriMesh& mesh = report.processed.mesh();
  Drawing sheet = pattern_sheet(mesh, report.unfold, geometry);
  Drawing to_cut = sheet_to_cut(mesh, report.unfold, geometry);
  return {std::move(geometry), std::move(sheet), std::move(to_cut)};
}

WrittenFiles paths_in(const fs::path& folder, MeshFormat format, const PatternFiles& pattern,
                      bool with_design, const Arguments& arguments) {
  const std::string extension = "." + std::string(to_string(format));
  const auto in_folder = [&](const std::string& name) { return utf8_of(folder / path_of(name)); };
  WrittenFiles paths = {{"processed", in_folder("processed" + extension)},
                        {"flat", in_folder("flat" + extension)},
                        {"report_json", in_folder("report.json")}};
  if (!arguments.has("--no-report")) paths["report_html"] = in_folder("report.html");
  for (const PatternFormat some : pattern.formats) {
    const std::string ending = "." + std::string(to_string(some));
    paths[role_of("pattern", some)] = in_folder("pattern" + ending);
    if (with_design) paths[role_of("as_designed", some)] = in_folder("as-designed" + ending);
  }
  if (pattern.output.pages) {
    paths["pattern_pages"] = in_folder("pattern-" + pattern.output.pages->paper.name + ".pdf");
  }
  if (arguments.has("--edge-lengths")) paths["edge_lengths"] = in_folder("edge-lengths.csv");
  if (arguments.has("--textured")) paths["textured"] = in_folder("textured.obj");
  if (arguments.has("--history")) paths["history"] = arguments.text("--history");
  paths.merge(fields_paths(arguments));
  return paths;
}

std::string page_of(const FlattenReport& report, const DrawnPattern& drawn,
                    const ReportPageOptions& words) {
  return html_report(report, drawn.geometry, drawn.sheet,
                     {.colors = words.colors,
                      .command = words.command,
                      .material = words.sheet.material,
                      .fits = words.sheet.fits,
                      .material_use = words.sheet.use,
                      .reference = reference_sweeps(report, words.reference),
                      .files = words.files,
                      .project = words.project});
}

std::vector<OutputFile> files_of(const FlattenReport& report, const DrawnPattern& drawn,
                                 const WrittenFiles& paths, MeshFormat format,
                                 const PatternFiles& pattern, const ReportPageOptions& words,
                                 const std::string& json) {
  const TriMesh& mesh = report.processed.mesh();
  std::vector<OutputFile> files = pattern_files(report, drawn.to_cut, paths, pattern);
  files.push_back({path_of(paths.at("processed")), format_mesh(mesh, format)});
  files.push_back(
      {path_of(paths.at("flat")), format_mesh(flat_mesh(mesh, report.unfold.pattern), format)});
  files.push_back({path_of(paths.at("report_json")), json});
  if (paths.contains("report_html")) {
    ReportPageOptions of_page = words;
    of_page.files = files_beside_page(paths);
    files.push_back({path_of(paths.at("report_html")), page_of(report, drawn, of_page)});
  }
  if (paths.contains("textured")) {
    files.push_back({path_of(paths.at("textured")),
                     format_textured_obj(mesh, in_millimetres(report.unfold.pattern.positions,
                                                              report.unfold.unit))});
  }
  if (paths.contains("edge_lengths")) {
    files.push_back({path_of(paths.at("edge_lengths")),
                     edge_lengths_csv(report.processed, report.unfold.pattern.positions,
                                      report.unfold.unit, drawn.geometry.options)});
  }
  const auto history = paths.find("history");
  if (history != paths.end()) {
    files.push_back({path_of(history->second), history_csv(report.evolve.result.history)});
  }
  if (paths.contains("fields") || paths.contains("fields_vertices")) {
    std::vector<OutputFile> more = fields_files(mesh, fields_of(report), paths);
    std::move(more.begin(), more.end(), std::back_inserter(files));
  }
  return files;
}

}  // namespace planish::cli
