#include <algorithm>

#include <planish/flatten/frontier.h>
#include <planish/io/mesh_format.h>
#include <planish/report/html_report.h>
#include <planish/report/json_report.h>

#include "commands/commands.h"
#include "flags/constraint_flags.h"
#include "flags/material_flag.h"
#include "flags/method_flags.h"
#include "flags/quantities.h"
#include "flags/scale_flag.h"
#include "flags/units.h"
#include "model/model_flags.h"
#include "output/open_page.h"
#include "platform/path.h"
#include "shell/failures.h"
#include "shell/file_name.h"
#include "shell/session.h"
#include "shell/values.h"
#include "text/frontier_text.h"
#include "text/summary.h"
#include "text/written_text.h"

namespace planish::cli {

namespace {

constexpr Range k_points = {8.0, 100.0};

FlagGroup frontier_flags() {
  std::vector<std::string> methods = method_names();
  methods.erase(std::remove(methods.begin(), methods.end(), Auto::name), methods.end());
  std::vector<std::string> choices = methods;
  choices.emplace_back(k_all_methods);
  return {"What to run",
          {{"--points",
            "N",
            "number of points of the curve, 8 to 100, evenly spaced on a logarithmic scale "
            "(default: stops at 2, 1, 0.5 and 0.1 % rms, and flat)",
            0,
            false,
            {.range = k_points}},
           {"--max-strain",
            "X",
            "a limit of the largest strain: the chart marks it and the curve gets a point for it "
            "(0.02 or 2%)",
            0,
            false,
            {.type = ValueType::share, .range = {0.0, 1.0}}},
           material_flag(),
           {"--methods",
            "NAMES",
            "methods to compare with, separated by commas: " + list_of(methods) +
                "; all (default: none)",
            0,
            false,
            {.choices = choices}}}};
}

/// The limit that --max-strain or --material names.
StrainLimits limit_from(const Arguments& arguments) {
  if (arguments.has("--material")) return one_limit_of_material(arguments);
  if (!arguments.has("--max-strain")) return {};
  const double limit = quantity_value("--max-strain", arguments.value("--max-strain"),
                                      Quantity::share, {0.0, 1.0}, arguments);
  if (limit == 0.0) throw UsageError("--max-strain is 0 but must be more: the curve ends there");
  return {.max = limit};
}

std::vector<CompareRun> others_from(const Arguments& arguments) {
  if (!arguments.has("--methods")) return {};
  std::vector<CompareRun> runs = runs_from(arguments);
  const auto is_auto = [](const CompareRun& run) { return name_of(run.method) == Auto::name; };
  if (!asks_for_all_methods(arguments) && std::any_of(runs.begin(), runs.end(), is_auto)) {
    throw UsageError("method auto draws the curve: --methods names others");
  }
  runs.erase(std::remove_if(runs.begin(), runs.end(), is_auto), runs.end());
  return runs;
}

/// What makes a file from a report; by the ending of its name.
using Writer = std::string (*)(const FrontierReport&);

std::string html_of(const FrontierReport& report) {
  return html_report(report);
}

/// @throws Error unsupported_format
Writer writer_of(const std::string& output) {
  const std::string extension = extension_of(output);
  if (extension == ".svg") return frontier_svg;
  if (extension == ".html") return html_of;
  if (extension == ".csv") return frontier_csv;
  throw Error(ErrorCode::unsupported_format,
              "a frontier cannot be written as \"" + extension + "\": use .svg, .html or .csv",
              {.path = output});
}

FrontierOptions options_from(const Arguments& arguments) {
  FrontierOptions options;
  if (arguments.has("--points"))
    options.points = whole_number_of("--points", arguments.value("--points"), k_points);
  options.limits = limit_from(arguments);
  options.others = others_from(arguments);
  options.unit = unit_from(arguments);
  return options;
}

void warn_of_failures(Session& session, const FrontierReport& report) {
  for (const FrontierFailure& failed : report.failures)
    warn_of_method(session, failed.method, failed.failure);
}

CommandResult run_frontier(const Arguments& arguments, Session& session) {
  // Check the request before any work.
  const std::string& path = arguments.operands.front();
  FrontierOptions options = options_from(arguments);
  const bool writes = arguments.has("--output");
  const std::string output = arguments.text("--output");
  const Writer writer = writes ? writer_of(output) : nullptr;
  if (arguments.has("--open") && extension_of(output) != ".html")
    throw UsageError("flag --open opens a page that is written: say where, with --output X.html");

  Model input = read_piece(path, arguments, session);
  const std::string size = size_text(input.mesh);
  const auto report = about(path, [&] {
    const Patch patch(std::move(input.mesh));
    options.constraints = constraints_from(arguments, patch, session);
    return frontier(patch, input.pieces.front(), options, session.job_context({}));
  });

  note_cautions(session, path, report.cautions, report.unit);
  std::string json = json_report(report);
  std::string text = path + "  (" + size + ")\n\n" + frontier_text(report);
  warn_of_failures(session, report);
  if (report.curve.empty() && !report.failures.empty()) {
    return {text, json, k_exit_failed, path + ": no run of auto had a result"};
  }
  CommandResult outcome = {std::move(text), std::move(json)};
  if (!writes) return outcome;
  const std::vector<OutputFile> files = {{path_of(output), writer(report)}};
  outcome.text += written_text(files);
  session.write(files);
  open_if_asked(arguments, path_of(output), session);
  return outcome;
}

}  // namespace

Command frontier_command() {
  return {"frontier",
          "the price of less strain: strain against change of form",
          "INPUT [-o FILE]",
          "Runs method auto with smaller and smaller limits of rms strain, and to flattenable, "
          "each time from the design. Unfolds each result, and prints the strain of its pattern, "
          "how far the vertices moved and how much the surface bends. Other methods can be shown "
          "beside it, each with its usual number of sweeps.",
          {"INPUT"},
          {{"Output",
            {{"--output",
              "FILE",
              "a chart (.svg), a page (.html) or all figures (.csv)",
              'o',
              false,
              {.extensions = {"svg", "html", "csv"}}},
             unit_flag(),
             scale_flag(),
             open_flag()}},
           model_flags(),
           frontier_flags(),
           constraint_flags()},
          {"planish frontier panel.obj", "planish frontier panel.obj -o frontier.svg --points 12",
           "planish frontier panel.obj --material leather -o frontier.html"},
          run_frontier,
          false,
          false,
          {{.extensions = names_of(k_mesh_formats)}}};
}

}  // namespace planish::cli
