#include <algorithm>
#include <filesystem>

#include <planish/io/mesh_format.h>
#include <planish/report/html_report.h>
#include <planish/report/json_report.h>

#include "commands/commands.h"
#include "flags/constraint_flags.h"
#include "flags/method_flags.h"
#include "flags/units.h"
#include "platform/path.h"
#include "shell/failures.h"
#include "shell/file_name.h"
#include "shell/output_folder.h"
#include "shell/session.h"
#include "text/compare_text.h"
#include "text/summary.h"

namespace planish::cli {

namespace {

namespace fs = std::filesystem;

std::vector<OutputFile> files_of(const CompareReport& report, const fs::path& folder,
                                 MeshFormat format, const std::string& json) {
  std::vector<OutputFile> files = {{folder / "compare.html", html_report(report)},
                                   {folder / "compare.csv", history_csv(report)},
                                   {folder / "compare.json", json}};
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

CommandResult run_compare(const Arguments& arguments, Session& session) {
  // What can be wrong with the request is told before any work.
  const std::string& path = arguments.operands.front();
  const std::vector<CompareRun> runs = runs_from(arguments);
  CompareOptions options = {.unit = unit_from(arguments)};
  const bool writes = arguments.has("--output");
  const fs::path folder = output_folder(arguments.value_or("--output", ""));

  ReadResult input = session.read(path);
  const std::string size = size_text(input.mesh);
  const auto report = about(path, [&] {
    const Patch patch(std::move(input.mesh));
    options.constraints = constraints_from(arguments, patch, session);
    return compare(patch, stem_of(path), runs, options, session.job_context({}));
  });

  std::string json = json_report(report);
  std::string text = path + "  (" + size + ")\n\n" + compare_text(report);
  warn_of_failures(session, report);
  if (std::none_of(report.runs.begin(), report.runs.end(),
                   [](const ComparedMethod& method) { return method.evolve.has_value(); })) {
    return {text, json, k_exit_failed, path + ": no method could be run"};
  }
  std::vector<OutputFile> files;
  if (writes) files = files_of(report, folder, output_format(input.format), json);
  if (writes) text += written_text(files);
  CommandResult outcome = {std::move(text), std::move(json)};
  session.write(files, folder);
  return outcome;
}

}  // namespace

Command compare_command() {
  return {"compare",
          "try several methods on a patch, side by side",
          "INPUT [-o FOLDER]",
          "Evolves a patch by one method after the other, each from the patch as it came, lays "
          "every result flat, and prints what each did to defects, strain, form and time. With -o "
          "also writes a page with charts and pictures (compare.html), every sweep "
          "(compare.csv), all figures (compare.json) and the evolved meshes. What is not a disk "
          "is compared without patterns.",
          {"INPUT"},
          {{"Output",
            {{"--output", "FOLDER", "where to write; without it nothing is written", 'o'},
             unit_flag()}},
           compare_flags(),
           constraint_flags()},
          {"planish compare panel.obj",
           "planish compare panel.obj --methods controllable,classical -o compared"},
          run_compare};
}

}  // namespace planish::cli
