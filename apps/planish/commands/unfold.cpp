#include <algorithm>
#include <array>
#include <utility>

#include <planish/io/mesh_format.h>
#include <planish/report/json_report.h>
#include <planish/sheet/pattern_sheet.h>

#include "batch/several_files.h"
#include "commands/commands.h"
#include "commands/jobs.h"
#include "cut/cut_flag.h"
#include "flags/annotation_flags.h"
#include "flags/limit_flags.h"
#include "flags/scale_flag.h"
#include "flags/unfold_flags.h"
#include "flags/units.h"
#include "model/model_flags.h"
#include "output/machine.h"
#include "output/pattern_notes.h"
#include "output/pattern_output.h"
#include "platform/path.h"
#include "product/seams.h"
#include "shell/failures.h"
#include "shell/file_name.h"
#include "shell/session.h"
#include "shell/text.h"
#include "shell/values.h"
#include "text/own_seams.h"
#include "text/summary.h"

namespace planish::cli {

namespace {

/// @throws Error unsupported_format
void check_format(const std::string& path) {
  if (pattern_format_of(path)) return;
  const std::string extension = lower_extension(path);
  const auto known = [&](MeshFormat format) {
    return extension == "." + std::string(to_string(format));
  };
  if (std::any_of(k_mesh_formats.begin(), k_mesh_formats.end(), known)) return;
  throw Error(ErrorCode::unsupported_format,
              "a pattern cannot be written as " +
                  (extension.empty() ? "a file without extension" : "\"" + extension + "\"") +
                  ": use .svg, .dxf, .pdf or .plt, or .obj, .ply, .stl or .off for a flat mesh",
              {.path = path});
}

/// What is written, and the pattern that it draws; empty of meshes.
struct Written {
  std::string content;
  PatternGeometry pattern = {};
  Drawing sheet = {};
};

Written written_as(const std::string& path, const std::string& name, const Patch& patch,
                   const UnfoldReport& report, const PatternOutput& output,
                   const PatternOptions& annotations) {
  const auto format = pattern_format_of(path);
  const TriMesh& mesh = patch.mesh();
  if (!format) return {format_mesh(flat_mesh(mesh, report.pattern), mesh_format_of(path_of(path)))};
  PatternGeometry pattern = pattern_geometry(mesh, report, name, annotations);
  Drawing sheet = sheet_to_cut(mesh, report, pattern);
  std::string content =
      output.pages ? tiled_file(sheet, output) : pattern_file(sheet, *format, output);
  return {std::move(content), std::move(pattern), std::move(sheet)};
}

std::vector<std::string> output_names() {
  return {"svg", "dxf", "pdf", "plt", "obj", "ply", "stl", "off"};
}

/// @param output a path that has the extension of what is written
UnfoldRequest request_from(const Arguments& arguments, const std::string& output) {
  check_format(output);
  std::vector<PatternFormat> formats;
  if (const auto format = pattern_format_of(output)) formats.push_back(*format);
  refuse_idle_pattern_flags(arguments, formats);
  return unfold_request_from(arguments, !formats.empty());
}

/// The figures of one of several files for people.
std::string line_of(const UnfoldReport& report) {
  const Pattern& pattern = report.pattern;
  const std::string size =
      right(short_number(pattern.width), 9) + right(short_number(pattern.height), 9);
  return right(percent(report.strain.rms), 10) + right(percent(report.strain.p99), 9) +
         right(percent(report.strain.max), 9) + size + " " + std::string(to_string(report.unit)) +
         (pattern.overlaps ? " laps" : "") + "\n";
}

void unfold_into(WorkFile& file, const std::filesystem::path& place, const UnfoldRequest& request,
                 const Arguments& arguments, Session& session) {
  const std::string& path = file.report.path;
  Model model = read_piece(path, arguments, session);
  about(path, [&] {
    const Patch patch(std::move(model.mesh));
    PatternOptions annotations =
        annotations_on(request.annotations, arguments, patch, model.pieces.front(), session);
    const std::vector<Caution> cautions = find_cautions(patch);
    annotations.cautions = words_of(cautions);
    note_cautions(session, path, cautions, request.unit);
    UnfoldReport report =
        unfold_patch(patch, request.unit, request.options, session.job_context(path));
    report.turned = model.turned;
    file.report.figures = unfolded_figures(report, cautions);
    file.text = line_of(report);
    file.misses = !all_kept(report.limits);
    if (place.empty()) return;
    Written written = written_as(utf8_of(place), model.pieces.front(), patch, report,
                                 request.output, annotations);
    note_filled(session, written.pattern);
    file.files = {{place, std::move(written.content)}};
  });
}

CommandResult unfold_several(const Arguments& all, Session& session) {
  const std::string extension = "." + output_format_from(all, output_names()).value_or("svg");
  const Arguments arguments =
      with_machine(with_files_that_are_asked_for(all, session), "pattern" + extension);
  refuse_single_file_flags(
      arguments, std::array{"--cut", "--avoid", "--symmetric", "--mirror-surface", "--notches",
                            "--marks", "--edge-allowances", "--inner-lines", "--piece-name"});
  const UnfoldRequest request = request_from(arguments, "pattern" + extension);
  const SeveralFiles job = {
      .columns = unfolded_columns(),
      .heads = "rms strain     99 %  largest    width   height",
      .missed_before = "a limit of strain is missed by ",
      .missed_behind = "",
      .extension = [&](const std::string&) { return std::string(extension); },
      .work = [&](WorkFile& file,
                  const auto& place) { unfold_into(file, place, request, arguments, session); }};
  return run_several(job, arguments, session);
}

CommandResult run_unfold(const Arguments& given, Session& session) {
  if (takes_several(given)) return unfold_several(given, session);
  output_format_from(given, output_names());
  const std::string output = given.text("--output");
  const Arguments arguments = with_machine(given, output);
  UnfoldRequest request = request_from(arguments, output);

  const std::string& path = arguments.operands.front();
  Model model = read_piece(path, arguments, session);
  const std::string& name = model.pieces.front();
  const CutInput input = cut_as_asked(std::move(model.mesh), path, arguments, session);
  request.options.symmetric_in = input.symmetric_in;
  const Patch patch = about(path, [&] { return Patch(input.mesh); });
  auto report = about(path, [&] {
    request.annotations =
        annotations_on(std::move(request.annotations), arguments, patch, name, session);
    return unfold_patch(patch, request.unit, request.options, session.job_context(path));
  });
  report.turned = model.turned;
  const std::vector<Caution> cautions = find_cautions(patch);
  request.annotations.cautions = words_of(cautions);
  const Written written = about(path, [&] {
    return written_as(output, name, patch, report, request.output, request.annotations);
  });
  warn_of_pattern(session, report, arguments.has("--unit"));
  note_unequal_seams(session, patch, report);
  note_pattern(session, written.pattern);
  const std::vector<OutputFile> files = {{path_of(output), written.content}};
  if (const auto format = pattern_format_of(output)) {
    if (format == PatternFormat::plt) note_plotter_reach(session, report);
    note_spelling(session, words_of(name, request.annotations.label), {*format}, request.output);
    note_empty_layers(session, written.sheet, request.output);
    if (!request.output.pages) note_divided_pages(session, files, request.output);
  }
  CommandResult outcome = {path + " -> " + output + "  (" + size_text(input.mesh) + ")\n\n" +
                               unfold_text(report, cautions),
                           json_report(report, cautions, figures_of_cut(input.cut))};
  session.write(files);
  return with_limits_checked(std::move(outcome), report.limits);
}

}  // namespace

UnfoldRequest unfold_request_from(const Arguments& arguments, bool writes_sheet) {
  return {unit_from(arguments),
          pattern_output_from(arguments),
          {.match_seams = arguments.has("--match-seams"),
           .least_stretch = arguments.has("--least-stretch"),
           .limits = limits_from(arguments),
           .fold = fold_ends_from(arguments)},
          annotations_from(arguments, writes_sheet)};
}

Command unfold_command() {
  std::vector<Flag> flags = {
      {"--output",
       "OUTPUT",
       "the pattern at true size (.svg, .dxf, .pdf or .plt), or a flat mesh with z = 0 (.obj, "
       ".ply, .stl or .off); with several inputs the folder for the patterns",
       'o',
       true,
       {.extensions = output_names()}},
      unit_flag(),
      scale_flag(),
      match_seams_flag(),
      least_stretch_flag(),
      csv_flag(),
      output_format_flag(output_names(), "svg")};
  for (Flag& flag : cut_flags())
    flags.push_back(std::move(flag));
  for (Flag& flag : pattern_flags("divide the .pdf into pages to join"))
    flags.push_back(std::move(flag));
  std::vector<FlagGroup> groups = {{"Output", std::move(flags)},
                                   model_flags(),
                                   {"Limits of the pattern", limit_flags()},
                                   annotation_flags()};
  mark_first(groups,
             {"--output", "--unit", "--cut", "--match-seams", "--paper", "--allowance", "--notches",
              "--grain", "--piece-name", "--quantity", "--max-strain", "--material"});
  return {
      "unfold",
      "lay a patch flat as it is",
      "INPUT ... -o OUTPUT",
      "Lays a patch flat, with its stretch spread out and no flipped triangle. With a limit of "
      "strain, finds the pattern of least stretch that keeps it; if none does, writes the closest "
      "one and ends with exit code 3. The patch must be one piece without handles, and no tube; "
      "--cut open opens any other surface. Holes stay holes. For several inputs, or all mesh files "
      "of a folder, prints one line each and writes the patterns into the folder OUTPUT, which is "
      "not needed with --csv. If one fails the others go on, and the exit code is 1.",
      {"INPUT"},
      std::move(groups),
      {"planish unfold panel.obj -o pattern.svg",
       "planish unfold panel.obj -o pattern.svg --max-strain 8%",
       "planish unfold panel.obj -o pattern.pdf --paper a4",
       "planish unfold sleeve.obj -o pattern.svg --cut seam.txt",
       "planish unfold panel.obj -o pattern.dxf --allowance 10mm --notches notches.txt",
       "planish unfold panel.obj -o flat.obj --unit cm",
       "planish unfold patches -o patterns --csv figures.csv"},
      run_unfold,
      false,
      true,
      {{.extensions = names_of(k_mesh_formats)}}};
}

}  // namespace planish::cli
