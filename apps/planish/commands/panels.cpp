#include "cut/panels.h"

#include <map>
#include <utility>

#include <planish/core/version.h>
#include <planish/io/mesh_format.h>

#include <planish_json/json.h>

#include "commands/commands.h"
#include "flags/limit_flags.h"
#include "flags/scale_flag.h"
#include "flags/units.h"
#include "io/read_drawing.h"
#include "model/model_flags.h"
#include "platform/path.h"
#include "report/json_parts.h"
#include "shell/failures.h"
#include "shell/file_name.h"
#include "shell/session.h"
#include "shell/text.h"
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

/// The seams, in the coordinates of the product's file.
std::string lines_file(const PanelSuggestion& found, const Arguments& arguments) {
  const TriMesh in_file = as_in_file(found.mesh, arguments);
  DrawnLines drawn;
  for (const std::vector<Index>& seam : found.seams) {
    DrawnLine& line = drawn.lines.emplace_back();
    for (const Index v : seam)
      line.points.push_back(in_file.positions[v]);
  }
  return "# Seams for planish --cut\n" + format_obj_lines(drawn);
}

std::vector<OutputFile> panel_files(const PanelSuggestion& found, const CutInput& cut,
                                    const std::map<std::string, std::string>& paths,
                                    const Arguments& arguments) {
  std::vector<OutputFile> files;
  files.reserve(paths.size());
  for (const auto& [role, path] : paths) {
    files.push_back({path_of(path), role == "lines"
                                        ? lines_file(found, arguments)
                                        : format_mesh(cut.mesh, mesh_format_of(path_of(path)))});
  }
  return files;
}

std::string row_of(std::size_t number, const SuggestedPanel& panel) {
  std::string row = right(std::to_string(number), 7) + right(percent(panel.area), 10);
  if (!panel.has_pattern) return row + "  has no pattern\n";
  return row + right(percent(panel.strain.rms), 10) + right(percent(panel.strain.p99), 12) +
         right(percent(panel.strain.max), 10) + (panel.overlaps ? "  overlaps itself" : "") + "\n";
}

std::string panels_text(const PanelSuggestion& found, const Arguments& arguments,
                        const std::map<std::string, std::string>& paths, const std::string& path) {
  std::string text = panels_words(found, unit_from(arguments)) +
                     (found.met ? ": every piece keeps the limit of strain."
                                : ": not every piece keeps the limit of strain.") +
                     "\n\n";
  text += "  piece      area       rms  99 % of it   largest strain\n";
  for (std::size_t k = 0; k < found.panels.size(); ++k)
    text += row_of(k + 1, found.panels[k]);
  const std::string cut = paths.contains("lines") ? paths.at("lines") : "auto";
  return text + "\nPatterns of these pieces: planish flatten " + path + " --cut " + cut + "\n";
}

std::string panels_json(const PanelSuggestion& found, double jag, const Arguments& arguments,
                        const std::map<std::string, std::string>& paths) {
  Json panels = Json::array();
  for (const SuggestedPanel& panel : found.panels) {
    panels.push_back({{"area", panel.area},
                      {"has_pattern", panel.has_pattern},
                      {"overlaps", panel.overlaps},
                      {"strain", panel.strain}});
  }
  const Json object = {{"version", k_version},
                       {"unit", to_string(unit_from(arguments))},
                       {"met", found.met},
                       {"pieces", std::move(panels)},
                       {"seams", found.seams.size()},
                       {"length", found.length},
                       {"slits", found.tips},
                       {"cost", found.cost},
                       {"jag", jag},
                       {"files", Json(paths)}};
  return json_document(object) + "\n";
}

CommandResult run_panels(const Arguments& arguments, Session& session) {
  // Check the request before any work.
  panel_options_from(arguments);
  const auto paths = panel_paths(arguments);
  const std::string& path = arguments.operands.front();
  TriMesh mesh = read_whole(path, arguments, session);
  const Patch patch = about(path, [&] { return Patch(std::move(mesh)); });
  const PanelSuggestion found =
      about(path, [&] { return panels_as_asked(patch, path, arguments, session); });
  const CutInput cut = cut_into_panels(found);
  const std::vector<OutputFile> files = panel_files(found, cut, paths, arguments);
  std::string text =
      path + "  (" + size_text(patch.mesh()) + ")\n\n" + panels_text(found, arguments, paths, path);
  if (!files.empty()) text += written_text(files);
  CommandResult outcome = {std::move(text), panels_json(found, cut.cut->jag, arguments, paths)};
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
                    "make left equal right: auto where the product is symmetric, \"x=0\" names "
                    "the plane, no (default auto)"};
  symmetric.accepts = {.type = ValueType::text, .standard = "auto"};
  search.flags.push_back(std::move(symmetric));
  return {
      "panels",
      "where to cut a whole product into panels",
      "PRODUCT [-o LINES]",
      "Divides a product, closed or open, into few pieces with short seams, each with a pattern "
      "that keeps a limit of strain: 2 % rms if none is given. LINES is an .obj with the seams "
      "as lines, which any 3D program edits and --cut of other verbs takes. Prints each better "
      "answer when it finds one; Ctrl-C ends the search and keeps the best answer so far. Without "
      "-o or --apply nothing is written. Exit code 3: no division keeps the limit.",
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
