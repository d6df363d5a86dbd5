#include <algorithm>
#include <utility>

#include <planish/io/mesh_format.h>
#include <planish/report/json_report.h>
#include <planish/sheet/pattern_sheet.h>

#include "commands/commands.h"
#include "flags/annotation_flags.h"
#include "flags/cut_flag.h"
#include "flags/limit_flags.h"
#include "flags/match_seams_flag.h"
#include "flags/units.h"
#include "output/pattern_output.h"
#include "platform/path.h"
#include "product/seams.h"
#include "shell/failures.h"
#include "shell/file_name.h"
#include "shell/session.h"
#include "shell/text.h"
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

PatternOutput output_from(const Arguments& arguments) {
  const auto format = pattern_format_of(arguments.flags.at("--output"));
  std::vector<PatternFormat> formats;
  if (format) formats.push_back(*format);
  refuse_idle_pattern_flags(arguments, formats);
  return pattern_output_from(arguments);
}

std::string content_of(const std::string& path, const std::string& input, const Patch& patch,
                       const UnfoldReport& report, const PatternOutput& output,
                       const PatternOptions& annotations) {
  const auto format = pattern_format_of(path);
  if (!format)
    return format_mesh(flat_mesh(patch.mesh(), report.pattern), mesh_format_of(path_of(path)));
  const std::string name = stem_of(input);
  const Drawing sheet = pattern_sheet(patch, report, name, annotations);
  return output.paper ? tiled_file(sheet, output) : pattern_file(sheet, *format, output);
}

CommandResult run_unfold(const Arguments& arguments, Session& session) {
  const std::string& output = arguments.flags.at("--output");
  check_format(output);
  const Unit unit = unit_from(arguments);
  const PatternOutput how = output_from(arguments);
  const UnfoldOptions unfold_options = {.match_seams = arguments.has("--match-seams"),
                                        .limits = limits_from(arguments)};
  PatternOptions annotations = annotations_from(arguments, pattern_format_of(output).has_value());

  const std::string& path = arguments.operands.front();
  const CutInput input = cut_as_asked(session.read(path).mesh, path, arguments, session);
  const Patch patch = about(path, [&] { return Patch(input.mesh); });
  const auto report = about(path, [&] {
    const std::string name = stem_of(path);
    annotations = annotations_on(std::move(annotations), arguments, patch, name);
    return unfold_patch(patch, unit, unfold_options, session.job_context(path));
  });
  const std::string content =
      about(path, [&] { return content_of(output, path, patch, report, how, annotations); });
  warn_of_pattern(session, report);
  CommandResult outcome = {
      path + " -> " + output + "  (" + size_text(input.mesh) + ")\n\n" + unfold_text(report),
      json_report(report, figures_of_cut(input.cut))};
  session.write({{path_of(output), content}});
  return with_limits_checked(std::move(outcome), report.limits);
}

}  // namespace

Command unfold_command() {
  std::vector<Flag> flags = {
      {"--output", "OUTPUT",
       "the pattern at true size (.svg, .dxf, .pdf or .plt), or a flat mesh with z = 0 (.obj, "
       ".ply, .stl or .off)",
       'o', true},
      unit_flag(),
      cut_flag(),
      match_seams_flag()};
  for (Flag& flag : pattern_flags("divide the .pdf into pages to be joined"))
    flags.push_back(std::move(flag));
  std::vector<FlagGroup> groups = {
      {"Output", std::move(flags)}, {"Limits of the pattern", limit_flags()}, annotation_flags()};
  mark_first(groups,
             {"--output", "--unit", "--cut", "--match-seams", "--paper", "--allowance", "--notches",
              "--grain", "--piece-name", "--quantity", "--max-strain", "--material"});
  return {
      "unfold",
      "lay a patch flat as it is",
      "INPUT -o OUTPUT",
      "Lays a patch flat with the least stretch and no flipped triangle. With a limit of "
      "strain, finds the pattern of least stretch that keeps it; if none does, writes the closest "
      "one and ends with exit code 3. The patch must be a topological disk: one piece, one border, "
      "no handle. "
      "--cut opens one that is none.",
      {"INPUT"},
      std::move(groups),
      {"planish unfold panel.obj -o pattern.svg",
       "planish unfold panel.obj -o pattern.svg --max-strain 8%",
       "planish unfold panel.obj -o pattern.pdf --paper a4",
       "planish unfold sleeve.obj -o pattern.svg --cut seam.txt",
       "planish unfold panel.obj -o pattern.dxf --allowance 10mm --notches notches.txt",
       "planish unfold panel.obj -o flat.obj --unit cm"},
      run_unfold};
}

}  // namespace planish::cli
