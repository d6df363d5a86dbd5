#include "cut/panels_text.h"

#include <cstddef>
#include <utility>

#include <planish/core/version.h>

#include <planish_json/json.h>

#include "cut/panel_places.h"
#include "cut/panels.h"
#include "flags/scale_flag.h"
#include "io/read_drawing.h"
#include "mesh/split.h"
#include "report/json_parts.h"
#include "shell/text.h"

namespace planish::cli {

namespace {

/// Of each panel; all are empty where there is one.
std::vector<std::string> places_of(const PanelSuggestion& found, const TriMesh& cut) {
  if (found.panels.size() < 2) return std::vector<std::string>(found.panels.size());
  return places_of_pieces(split(cut, ""));
}

std::string row_of(std::size_t number, const std::string& place, const SuggestedPanel& panel) {
  std::string row =
      right(std::to_string(number), 7) + right(place, 7) + right(percent(panel.area), 9);
  if (!panel.has_pattern) return row + "  has no pattern\n";
  return row + right(percent(panel.strain.rms), 10) + right(percent(panel.strain.p99), 12) +
         right(percent(panel.strain.max), 10) + (panel.overlaps ? "  overlaps itself" : "") + "\n";
}

}  // namespace

std::string panels_text(const PanelSuggestion& found, const TriMesh& cut, Unit unit) {
  std::string text = panels_words(found, unit) +
                     (found.met ? ": every piece keeps the limit of strain."
                                : ": not every piece keeps the limit of strain.") +
                     "\n\n";
  text += "  piece  place     area       rms  99 % of it   largest strain\n";
  const std::vector<std::string> places = places_of(found, cut);
  for (std::size_t k = 0; k < found.panels.size(); ++k)
    text += row_of(k + 1, places[k], found.panels[k]);
  return text;
}

std::string panels_json(const PanelSuggestion& found, const CutInput& cut, Unit unit,
                        const std::map<std::string, std::string>& files) {
  const std::vector<std::string> places = places_of(found, cut.mesh);
  Json panels = Json::array();
  for (std::size_t k = 0; k < found.panels.size(); ++k) {
    const SuggestedPanel& panel = found.panels[k];
    panels.push_back({{"place", places[k].empty() ? Json(nullptr) : Json(places[k])},
                      {"area", panel.area},
                      {"has_pattern", panel.has_pattern},
                      {"overlaps", panel.overlaps},
                      {"strain", panel.strain}});
  }
  const Json object = {
      {"version", k_version},        {"unit", to_string(unit)},     {"met", found.met},
      {"pieces", std::move(panels)}, {"seams", found.seams.size()}, {"length", found.length},
      {"slits", found.tips},         {"cost", found.cost},          {"jag", cut.cut->jag},
      {"files", Json(files)}};
  return json_document(object) + "\n";
}

std::string panel_lines(const PanelSuggestion& found, const std::vector<std::vector<Vec3>>& fixed,
                        const Arguments& arguments) {
  std::vector<std::vector<Vec3>> seams = fixed;
  for (const std::vector<Index>& seam : found.seams) {
    std::vector<Vec3>& places = seams.emplace_back();
    for (const Index v : seam)
      places.push_back(found.mesh.positions[v]);
  }
  DrawnLines drawn;
  for (std::vector<Vec3>& places : seams)
    drawn.lines.push_back({as_in_file(TriMesh{std::move(places), {}}, arguments).positions, {}});
  return "# Seams for planish --cut\n" + format_obj_lines(drawn);
}

}  // namespace planish::cli
