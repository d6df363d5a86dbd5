#include "cut/panels.h"

#include <map>
#include <utility>

#include <planish/io/mesh_format.h>

#include "commands/commands.h"
#include "cut/panels_text.h"
#include "flags/limit_flags.h"
#include "flags/scale_flag.h"
#include "flags/units.h"
#include "model/model_flags.h"
#include "platform/path.h"
#include "shell/failures.h"
#include "shell/file_name.h"
#include "shell/session.h"
#include "shell/values.h"
#include "text/summary.h"
#include "text/written_text.h"

namespace planish::cli {

namespace {

/// What each file is for -> its path.
std::map<std::string, std::string> panel_paths(const Arguments& arguments) {
  auto paths = output_paths(arguments, {{"lines", "--output"}, {"mesh", "--apply"}});
  if (paths.contains("lines") && lower_extension(paths.at("lines")) != ".obj")
    throw Error(ErrorCode::unsupported_format, "the lines are an .obj file",
                {.path = paths.at("lines")});
  if (paths.contains("mesh")) mesh_format_of(path_of(paths.at("mesh")));
  return paths;
}

std::vector<OutputFile> panel_files(const PanelSuggestion& found, const CutInput& cut,
                                    const std::vector<std::vector<Vec3>>& fixed,
                                    const std::map<std::string, std::string>& paths,
                                    const Arguments& arguments) {
  std::vector<OutputFile> files;
  files.reserve(paths.size());
  for (const auto& [role, path] : paths) {
    files.push_back({path_of(path), role == "lines"
                                        ? panel_lines(found, fixed, arguments)
                                        : format_mesh(cut.mesh, mesh_format_of(path_of(path)))});
  }
  return files;
}

CommandResult run_panels(const Arguments& arguments, Session& session) {
  // Check the request before any work.
  panel_options_from(arguments);
  const auto paths = panel_paths(arguments);
  const std::string& path = arguments.operands.front();
  TriMesh mesh = read_whole(path, arguments, session);
  CutInput fixed =
      about(path, [&] { return cut_at_fixed_seams(std::move(mesh), path, arguments, session); });
  const Patch patch = about(path, [&] { return Patch(std::move(fixed.mesh)); });
  const PanelSuggestion found = about(path, [&] {
    return panels_as_asked(patch, path, arguments, session,
                           {.match_seams = arguments.has("--match-seams")});
  });
  const CutInput cut = cut_into_panels(found);
  const std::vector<OutputFile> files = panel_files(found, cut, fixed.lines, paths, arguments);
  std::string text = path + "  (" + size_text(patch.mesh()) + ")\n\n" +
                     panels_text(found, cut.mesh, unit_from(arguments)) +
                     "\nPatterns of these pieces: planish flatten " + path + " --cut " +
                     (paths.contains("lines") ? paths.at("lines") : "auto") + "\n";
  if (!files.empty()) text += written_text(files);
  CommandResult outcome = {std::move(text), panels_json(found, cut, unit_from(arguments), paths)};
  session.write(files);
  if (!found.met) {
    outcome.exit_code = k_exit_target_missed;
    outcome.complaint =
        "not every piece keeps the limit of strain; --effort with more moves may find how";
  }
  return outcome;
}

}  // namespace

Command panels_command() {
  FlagGroup search = {"What to look for", limit_flags()};
  for (Flag& flag : panel_flags())
    search.flags.push_back(std::move(flag));
  Flag symmetric = {"--symmetric", "PLANE",
                    "make left equal right: auto does so if the product is symmetric, \"x=0\" "
                    "names the plane, no (default auto)"};
  symmetric.accepts = {.type = ValueType::text, .standard = "auto"};
  search.flags.push_back(std::move(symmetric));
  search.flags.push_back(fixed_seams_flag());
  search.flags.push_back({"--match-seams", "",
                          "keep the limit even with both sides of each seam equally long, as "
                          "flatten --cut auto makes them"});
  return {
      "panels",
      "choose where to cut a whole product into panels",
      "PRODUCT [-o LINES]",
      "Divides a product, closed or open, into few pieces with short seams. The pattern of each "
      "piece keeps a limit of strain: 2 % rms if you give none. LINES is an .obj with the seams as "
      "lines, which any 3D program can edit and which --cut of other verbs takes. Prints each "
      "better answer as soon as it finds one; Ctrl-C ends the search and keeps the best answer so "
      "far. Without -o or --apply no file is written. Exit code 3: no division keeps the limit.",
      {"PRODUCT"},
      {{"Output",
        {{"--output",
          "LINES",
          "the seams as lines: .obj",
          'o',
          false,
          {.type = ValueType::file, .extensions = {"obj"}}},
         {"--apply",
          "FILE",
          "the product cut open: .obj, .ply, .stl or .off",
          0,
          false,
          {.extensions = names_of(k_mesh_formats)}},
         unit_flag(),
         scale_flag()}},
       model_flags(),
       std::move(search)},
      {"planish panels hat.obj", "planish panels shoe.obj -o seams.obj --material leather",
       "planish flatten shoe.obj --cut seams.obj"},
      run_panels,
      false,
      false,
      {{.extensions = names_of(k_mesh_formats)}}};
}

}  // namespace planish::cli
