#include <algorithm>
#include <array>
#include <filesystem>

#include <planish/io/mesh_format.h>
#include <planish/report/html_report.h>
#include <planish/report/json_report.h>

#include "batch/several_files.h"
#include "commands/commands.h"
#include "flags/constraint_flags.h"
#include "flags/method_flags.h"
#include "flags/scale_flag.h"
#include "flags/units.h"
#include "model/model_flags.h"
#include "model/other_methods.h"
#include "output/open_page.h"
#include "platform/path.h"
#include "report/json_parts.h"
#include "shell/failures.h"
#include "shell/file_name.h"
#include "shell/output_folder.h"
#include "shell/session.h"
#include "shell/text.h"
#include "shell/values.h"
#include "text/compare_text.h"
#include "text/summary.h"
#include "text/written_text.h"

namespace planish::cli {

namespace {

namespace fs = std::filesystem;

std::vector<OutputFile> files_of(const CompareReport& report, const fs::path& folder,
                                 MeshFormat format, const std::string& json) {
  std::vector<OutputFile> files = {{folder / path_of("compare.html"), html_report(report)},
                                   {folder / path_of("compare.csv"), history_csv(report)},
                                   {folder / path_of("compare.json"), json}};
  for (const ComparedMethod& method : report.runs) {
    if (!method.evolve) continue;
    const std::string name = report.name + "-" + std::string(name_of(method.run.method)) + "." +
                             std::string(to_string(format));
    files.push_back(
        {folder / path_of(name),
         format_mesh({method.evolve->result.positions, report.input.triangles()}, format)});
  }
  return files;
}

void warn_of_failures(Session& session, const CompareReport& report) {
  for (const ComparedMethod& method : report.runs) {
    if (method.failure) warn_of_method(session, method.run.method, *method.failure);
  }
}

bool has_result(const CompareReport& report) {
  return std::any_of(report.runs.begin(), report.runs.end(),
                     [](const ComparedMethod& method) { return method.evolve.has_value(); });
}

std::string line_of(const std::string& name, const Flattenability& figures,
                    const std::optional<UnfoldReport>& unfold, const std::string& rest) {
  return left(name, 21) + right(short_number(figures.e_max), 8) +
         right(unfold ? short_number(100.0 * unfold->strain.rms) : "-", 8) + rest + "\n";
}

/// The figures of one of several files for people: a line for the input and for each method.
std::string lines_of(const CompareReport& report) {
  std::string text = line_of("input", report.before.figures, report.design_least_stretch, "");
  for (const ComparedMethod& method : report.runs) {
    const std::string name(name_of(method.run.method));
    text += std::string(27, ' ');
    if (!method.evolve) {
      text += left(name, 21) + "  failed\n";
      continue;
    }
    text += line_of(name, method.evolve->after.figures, method.unfold,
                    right(short_number(100.0 * method.evolve->deviation.rms_over_diagonal), 8) +
                        right(method.evolve->fairness.is_smooth() ? "yes" : "no", 8));
  }
  return text;
}

/// The methods that --methods names, then what --with gives.
std::vector<CompareRun> all_runs(const std::string& path, const Arguments& arguments,
                                 Session& session) {
  std::vector<CompareRun> runs;
  if (!arguments.has("--with") || !asks_for_no_method(arguments)) runs = runs_from(arguments);
  for (CompareRun& run : runs_with(path, arguments, session))
    runs.push_back(std::move(run));
  return runs;
}

void compare_into(WorkFile& file, const fs::path& place, const Arguments& arguments,
                  Session& session) {
  const std::string& path = file.report.path;
  const std::vector<CompareRun> runs = all_runs(path, arguments, session);
  Model input = read_piece(path, arguments, session);
  const CompareReport report = about(path, [&] {
    const Patch patch(std::move(input.mesh));
    const CompareOptions options = {unit_from(arguments),
                                    constraints_from(arguments, patch, session)};
    return compare(patch, input.pieces.front(), runs, options, session.job_context({}));
  });
  note_cautions(session, path, report.cautions, report.unit);
  file.report.figures = report;
  file.text = lines_of(report);
  if (!has_result(report)) {
    file.report.failure = report.runs.front().failure;
  } else if (!place.empty()) {
    file.files = files_of(report, place, output_format(input.format), json_report(report));
  }
}

CommandResult compare_several(const Arguments& all, Session& session) {
  const Arguments arguments = with_files_that_are_asked_for(all, session);
  refuse_single_file_flags(arguments, std::array{"--fix", "--weights", "--open"});
  all_runs({}, arguments, session);  // checks the request
  unit_from(arguments);
  const SeveralFiles job = {
      .columns = compared_columns(),
      .heads = "method                  e_max  strain deviat.  smooth",
      .missed_before = {},
      .missed_behind = {},
      .extension = [](const std::string&) { return std::string(); },
      .work = [&](WorkFile& file,
                  const auto& place) { compare_into(file, place, arguments, session); }};
  return run_several(job, arguments, session);
}

CommandResult run_compare(const Arguments& arguments, Session& session) {
  if (takes_several(arguments)) return compare_several(arguments, session);
  // Check the request before any work.
  const std::string& path = arguments.operands.front();
  const std::vector<CompareRun> runs = all_runs(path, arguments, session);
  CompareOptions options = {.unit = unit_from(arguments)};
  const bool writes = arguments.has("--output");
  if (arguments.has("--open") && !writes)
    throw UsageError("flag --open opens a page that is written: say where, with --output FOLDER");
  const fs::path folder = output_folder(arguments.text("--output"));

  Model input = read_piece(path, arguments, session);
  const std::string size = size_text(input.mesh);
  const auto report = about(path, [&] {
    const Patch patch(std::move(input.mesh));
    options.constraints = constraints_from(arguments, patch, session);
    return compare(patch, input.pieces.front(), runs, options, session.job_context({}));
  });

  note_cautions(session, path, report.cautions, report.unit);
  std::string json = json_report(report);
  std::string text = path + "  (" + size + ")\n\n" + compare_text(report);
  warn_of_failures(session, report);
  if (!has_result(report)) {
    return {text, json, k_exit_failed, path + ": no method could be run"};
  }
  std::vector<OutputFile> files;
  if (writes) files = files_of(report, folder, output_format(input.format), json);
  if (writes) text += written_text(files);
  CommandResult outcome = {std::move(text), std::move(json)};
  session.write(files, folder);
  open_if_asked(arguments, folder / path_of("compare.html"), session);
  return outcome;
}

}  // namespace

Command compare_command() {
  return {"compare",
          "run several methods on a patch, side by side",
          "INPUT ... [-o FOLDER]",
          "Runs one method after the other on the same input patch, lays each result flat, and "
          "prints defects, strain, change of form and time. With -o also writes a page with charts "
          "and pictures (compare.html), the figures of every sweep (compare.csv), all figures "
          "(compare.json) and the evolved meshes. A mesh that is no disk is compared without "
          "patterns. For several inputs, or all mesh files of a folder, prints one line for each "
          "file and method, and writes each input into a folder of its own below FOLDER. If one "
          "fails the others go on, and the exit code is 1. --with adds results of other programs.",
          {"INPUT"},
          {{"Output",
            {{"--output", "FOLDER", "where to write; without it no file is written", 'o'},
             unit_flag(),
             scale_flag(),
             open_flag(),
             {"--csv",
              "FILE",
              "write the figures of all inputs as comma-separated values, one line for each file "
              "and method",
              0,
              false,
              {.extensions = {"csv"}}}}},
           model_flags(),
           compare_flags(),
           {"Results from outside", {with_flag()}},
           constraint_flags()},
          {"planish compare panel.obj",
           "planish compare panel.obj --methods controllable,classical -o compared",
           "planish compare patches --csv figures.csv",
           "planish compare panel.obj --methods auto --with \"mine=./mine {in} {out}\""},
          run_compare,
          false,
          true,
          {{.extensions = names_of(k_mesh_formats)}}};
}

}  // namespace planish::cli
