#include "cut/panels.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>

#include <planish/mesh/cut.h>
#include <planish/mesh/surface_line.h>
#include <planish/mesh/symmetry.h>
#include <planish/unfold/unfold.h>

#include "cut/caps.h"
#include "cut/requested_lines.h"
#include "cut/symmetric_design.h"
#include "flags/limit_flags.h"
#include "flags/units.h"
#include "mesh/mean_edge.h"
#include "shell/failures.h"
#include "shell/text.h"
#include "shell/values.h"
#include "text/lengths.h"

namespace planish::cli {

namespace {

constexpr Range k_moves = {1.0, 1000.0};
constexpr std::size_t k_usual_moves = 6;

constexpr std::array k_preferences = {PanelPreference::few, PanelPreference::shortest,
                                      PanelPreference::simple};

}  // namespace

std::vector<Flag> panel_flags() {
  return {
      {"--prefer-cuts",
       "WHAT",
       "what a division into panels must have before all else: few pieces (few), short seams "
       "(short), or no slits that end inside a piece (simple); default few",
       0,
       false,
       {.choices = names_of(k_preferences), .standard = std::string(to_string(k_preferences[0]))}},
      {"--effort",
       "N",
       "number of divisions to try (1 to 1000, default " + std::to_string(k_usual_moves) +
           "); a larger number never gives a worse result",
       0,
       false,
       {.range = k_moves, .standard = std::to_string(k_usual_moves)}}};
}

PanelOptions panel_options_from(const Arguments& arguments) {
  PanelOptions options;
  if (const StrainLimits limits = limits_from(arguments); limits.any()) options.limits = limits;
  options.prefer = value_named(
      "kind of cuts", arguments.text("--prefer-cuts", std::string(to_string(k_preferences[0]))),
      k_preferences);
  options.moves = static_cast<std::size_t>(whole_number_of(
      "--effort", arguments.value("--effort", static_cast<int>(k_usual_moves)), k_moves));
  return options;
}

Flag fixed_seams_flag() {
  Flag flag = {"--seams", "LINES",
               "lines that must be seams, written as for --cut: a drawing (.obj), \"plane x=0\", "
               "\"creases 30deg\", ...; other seams join them; may be repeated"};
  flag.accepts.repeats = true;
  flag.accepts.type = ValueType::file;
  return flag;
}

CutInput cut_at_fixed_seams(TriMesh mesh, const std::string& path, const Arguments& arguments,
                            Session& session) {
  if (!arguments.has("--seams")) return {std::move(mesh)};
  Arguments of_cut = arguments;
  of_cut.flags.erase("--symmetric");  // that is asked of the panels
  of_cut.flags["--cut"] = arguments.flags.at("--seams");
  if (asks_to_open(of_cut) || asks_for_panels(of_cut))
    throw UsageError("flag --seams takes lines, not open or auto");
  for (const Flag& flag : panel_flags())
    of_cut.flags.erase(flag.name);
  return asked_in("--seams", [&] { return cut_as_asked(std::move(mesh), path, of_cut, session); });
}

void note_idle_panel_flags(const Arguments& arguments, Session& session) {
  for (const char* flag : {"--prefer-cuts", "--effort"}) {
    if (arguments.has(flag)) session.note(std::string(flag) + " has no effect without --cut auto");
  }
}

/// In which the panels become mirror images; nothing where they need not.
std::optional<Plane> plane_of_panels(const Patch& patch, const std::string& path,
                                     const Arguments& arguments, Session& session) {
  const std::string asked = arguments.text("--symmetric", "auto");
  if (asked == "no") return std::nullopt;
  const Symmetry symmetry = requested_symmetry(patch, arguments);
  const bool is_symmetric = symmetry.largest <= symmetry_tolerance(patch.mesh());
  if (!is_symmetric && !arguments.has("--symmetric")) return std::nullopt;
  require_symmetric(patch, symmetry);
  if (!arguments.has("--symmetric"))
    session.note(path + ": left equals right, so the panels do; --symmetric no looks for others");
  return symmetry.plane;
}

PanelSuggestion panels_as_asked(const Patch& patch, const std::string& path,
                                const Arguments& arguments, Session& session,
                                const PanelRules& rules) {
  PanelOptions options = panel_options_from(arguments);
  const Unit unit = unit_from(arguments);
  options.match_seams = rules.match_seams;
  options.can_change = rules.can_change;
  options.open_crossings = k_hair / millimetres_per(unit);
  options.on_better = [&](const PanelSuggestion& better) {
    session.tell(path + ": " + panels_words(better, unit) +
                 (better.met ? "" : "; the limit is not kept"));
  };
  const Patch sound(without_caps(patch.mesh(), arguments, session));
  options.symmetric_in = plane_of_panels(sound, path, arguments, session);
  PanelSuggestion found = suggest_panels(sound, options, session.job_context(path));
  if (found.was_cancelled) {
    session.resume();
    session.note(path + ": the search was stopped; this is the best answer so far");
  }
  return found;
}

std::string panels_words(const PanelSuggestion& found, Unit unit) {
  std::string words = counted(found.panels.size(), "piece");
  if (found.seams.empty()) return words + " without a seam";
  words += ", " + ShownLengths(unit).text(found.length) + " of seam";
  if (found.tips > 0) words += ", " + counted(found.tips, "slit");
  return words;
}

CutInput cut_into_panels(const PanelSuggestion& found) {
  const Patch patch(found.mesh);
  const double edge = mean_edge_length(found.mesh);
  std::vector<CutPath> paths;
  CutOutcome outcome;
  for (const std::vector<Index>& seam : found.seams) {
    paths.push_back({seam, {}});
    std::vector<Vec3> line;
    line.reserve(seam.size());
    for (const Index v : seam)
      line.push_back(found.mesh.positions[v]);
    outcome.jag = std::max(outcome.jag, jag_of(line, edge));
  }
  CutMesh opened = cut_open(patch, paths);
  outcome.edges = opened.edges;
  outcome.length = opened.length;
  return {std::move(opened.mesh), outcome};
}

}  // namespace planish::cli
