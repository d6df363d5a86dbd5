#include <map>
#include <utility>

#include <planish/draw/format_drawing.h>
#include <planish/io/mesh_format.h>

#include "commands/commands.h"
#include "commands/jobs.h"
#include "flags/limit_flags.h"
#include "flags/material_flag.h"
#include "flags/scale_flag.h"
#include "flags/units.h"
#include "model/model_flags.h"
#include "platform/path.h"
#include "sheet/cut_sheet.h"
#include "shell/failures.h"
#include "shell/file_name.h"
#include "shell/session.h"
#include "shell/values.h"
#include "text/lengths.h"
#include "text/suggestion_text.h"
#include "text/summary.h"
#include "text/written_text.h"

namespace planish::cli {

namespace {

constexpr Range k_darts = {0.0, 50.0};

/// What each file is for -> its path.
std::map<std::string, std::string> suggestion_paths(const Arguments& arguments) {
  auto paths = output_paths(arguments,
                            {{"cuts", "--output"}, {"picture", "--picture"}, {"mesh", "--apply"}});
  if (paths.contains("picture") && lower_extension(paths.at("picture")) != ".svg") {
    throw Error(ErrorCode::unsupported_format, "the picture is an .svg file",
                {.path = paths.at("picture")});
  }
  if (paths.contains("mesh")) mesh_format_of(path_of(paths.at("mesh")));
  return paths;
}

std::vector<OutputFile> suggestion_files(const CutSuggestion& suggestion,
                                         const std::map<std::string, std::string>& paths, Unit unit,
                                         const std::string& name) {
  std::vector<OutputFile> files;
  for (const auto& [role, path] : paths) {
    if (role == "cuts") {
      files.push_back({path_of(path), suggestion_file(suggestion, unit)});
    } else if (role == "picture") {
      files.push_back({path_of(path), format_svg(cut_sheet(suggestion, unit, name))});
    } else {
      files.push_back(
          {path_of(path), format_mesh(suggestion.last.cut.mesh, mesh_format_of(path_of(path)))});
    }
  }
  return files;
}

CommandResult run_suggest_cuts(const Arguments& arguments, Session& session) {
  // Check the request before any work.
  const SuggestOptions options = suggest_options_from(arguments);
  const Unit unit = unit_from(arguments);
  const auto paths = suggestion_paths(arguments);
  const std::string& path = arguments.operands.front();
  const Model model = read_piece(path, arguments, session);
  const TriMesh& mesh = model.mesh;
  const auto suggestion =
      about(path, [&] { return suggest_cuts(Patch(mesh), options, session.job_context(path)); });
  note_cautions(session, path, suggestion.cautions, unit);
  const std::string& name = model.pieces.front();
  const auto files = about(path, [&] { return suggestion_files(suggestion, paths, unit, name); });
  std::string text =
      path + "  (" + size_text(mesh) + ")\n\n" + suggestion_text(suggestion, options, unit);
  if (!files.empty()) text += written_text(files);
  const auto size = unusual_size_text(suggestion.last.pattern, unit);
  if (size && !arguments.has("--unit")) session.note(*size);
  CommandResult outcome = {text, suggestion_json(suggestion, options, unit, paths)};
  session.write(files);
  return outcome;
}

}  // namespace

SuggestOptions suggest_options_from(const Arguments& arguments) {
  SuggestOptions options;
  if (const StrainLimits limits = limits_from(arguments); limits.any()) options.limits = limits;
  options.max_darts =
      whole_number_of("--max-cuts", arguments.value("--max-cuts", options.max_darts), k_darts);
  return options;
}

Command suggest_cuts_command() {
  return {
      "suggest-cuts",
      "find cuts that let a patch lie flat",
      "INPUT [-o CUTS]",
      "Looks for short cuts along edges with which a mesh lies flat and its pattern keeps a limit "
      "of strain: first seams that make one piece with one border, then darts, one after the "
      "other, each the best of a few. CUTS is a file for --cut of other verbs. Without -o, "
      "--picture or --apply no file is written. Ends with exit code 0 even if the limit is not "
      "met.",
      {"INPUT"},
      {{"Output",
        {{"--output", "CUTS", "the cuts: one a line, by its vertices", 'o'},
         {"--picture",
          "FILE",
          "the pattern without the darts, with the darts drawn on it: .svg",
          0,
          false,
          {.extensions = {"svg"}}},
         {"--apply",
          "FILE",
          "the mesh cut open: .obj, .ply, .stl or .off",
          0,
          false,
          {.extensions = names_of(k_mesh_formats)}},
         unit_flag(),
         scale_flag()}},
       model_flags(),
       {"What to look for",
        {{"--max-strain",
          "X",
          "limit of the largest strain of an edge (0.02 or 2%, default 2%); 2%@p99: on 99 % of the "
          "area",
          0,
          false,
          {.type = ValueType::share, .range = {0.0, 1.0}, .standard = "2%"}},
         material_flag(),
         {"--max-cuts",
          "N",
          "largest number of darts (0 to 50, default " +
              std::to_string(SuggestOptions{}.max_darts) + ")",
          0,
          false,
          {.range = k_darts, .standard = std::to_string(SuggestOptions{}.max_darts)}}}}},
      {"planish suggest-cuts hat.obj", "planish suggest-cuts hat.obj -o cuts.txt --max-strain 5%",
       "planish flatten hat.obj --cut cuts.txt"},
      run_suggest_cuts,
      false,
      false,
      {{.extensions = names_of(k_mesh_formats)}}};
}

}  // namespace planish::cli
