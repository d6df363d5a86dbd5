#include "flags/synonyms.h"

#include <algorithm>
#include <array>

namespace planish::cli {

namespace {

struct Alias {
  std::string_view name, flag;
};

constexpr std::array<Alias, 26> k_aliases = {{{"--seam-allowance", "--allowance"},
                                              {"--stretch", "--max-strain"},
                                              {"--max-stretch", "--max-strain"},
                                              {"--strain", "--max-strain"},
                                              {"--out", "--output"},
                                              {"--output-folder", "--output"},
                                              {"--output-dir", "--output"},
                                              {"--units", "--unit"},
                                              {"--format", "--formats"},
                                              {"--paper-size", "--paper"},
                                              {"--page-size", "--paper"},
                                              {"--tile", "--paper"},
                                              {"--tiles", "--paper"},
                                              {"--tiled", "--paper"},
                                              {"--materials", "--material"},
                                              {"--fabric-width", "--sheet"},
                                              {"--roll-width", "--sheet"},
                                              {"--sheet-size", "--sheet"},
                                              {"--gap", "--nest-gap"},
                                              {"--name", "--piece-name"},
                                              {"--copies", "--quantity"},
                                              {"--grainline", "--grain"},
                                              {"--grain-line", "--grain"},
                                              {"--colours", "--colors"},
                                              {"--fixed", "--fix"},
                                              {"--scale-factor", "--scale"}}};

struct Missing {
  std::string_view name, advice;
};

constexpr std::string_view k_no_bends =
    "bend lines are not computed; --inner-lines FILE draws lines that you name by their vertices";
constexpr std::string_view k_no_thickness =
    "the material has no thickness here; give the face that keeps its length when bent, usually "
    "the middle one";
constexpr std::string_view k_no_radius =
    "the radius of bends has no limit; --prefer smooth, the default of method auto, is nearest in "
    "purpose";
constexpr std::string_view k_map_switch =
    "the strain map is on screens only: in .svg and the report; --map draws it in .pdf too";
constexpr std::string_view k_sections =
    "sections are not computed; --inner-lines FILE draws lines that you name by their vertices";
constexpr std::string_view k_one_direction =
    "a material has one limit in all directions; --max-strain sets it, --grain draws the direction";
constexpr std::string_view k_darts =
    "planish suggest-cuts INPUT -o CUTS finds where to cut, and --cut CUTS cuts there";
constexpr std::string_view k_mirrored_flag =
    "--quantity 2 --mirrored 1 cuts a piece and its mirror image";
constexpr std::string_view k_fewer =
    "--remesh works on fewer vertices, and chooses their number itself";
constexpr std::string_view k_smooth =
    "--prefer smooth is the default of method auto; --smooth-first LENGTH smooths the design";

constexpr std::array<Missing, 28> k_missing = {{
    {"--bend-lines", k_no_bends},
    {"--bends", k_no_bends},
    {"--fold-lines", k_no_bends},
    {"--rulings", k_no_bends},
    {"--ruling-lines", k_no_bends},
    {"--thickness", k_no_thickness},
    {"--plate-thickness", k_no_thickness},
    {"--bend-radius", k_no_radius},
    {"--min-radius", k_no_radius},
    {"--min-bend-radius", k_no_radius},
    {"--no-strain-map", k_map_switch},
    {"--no-map", k_map_switch},
    {"--strain-map", k_map_switch},
    {"--stations", k_sections},
    {"--waterlines", k_sections},
    {"--sections", k_sections},
    {"--warp", k_one_direction},
    {"--weft", k_one_direction},
    {"--darts", k_darts},
    {"--auto-cut", k_darts},
    {"--mirror", k_mirrored_flag},
    {"--decimate", k_fewer},
    {"--simplify", k_fewer},
    {"--smooth", k_smooth},
    {"--smoothing", k_smooth},
    {"--verbose", "there is no more to show; --json prints every figure"},
    {"--force", "files that are there are replaced without asking"},
    {"--overwrite", "files that are there are replaced without asking"},
}};

}  // namespace

std::vector<std::string> aliases_of(std::string_view flag) {
  std::vector<std::string> names;
  for (const Alias& alias : k_aliases) {
    if (alias.flag == flag) names.emplace_back(alias.name);
  }
  return names;
}

std::string_view without_alias(std::string_view name) {
  const auto* const found = std::find_if(k_aliases.begin(), k_aliases.end(),
                                         [&](const Alias& alias) { return alias.name == name; });
  return found == k_aliases.end() ? name : found->flag;
}

std::string_view missing_flag_advice(std::string_view name) {
  const auto* const found = std::find_if(k_missing.begin(), k_missing.end(),
                                         [&](const Missing& flag) { return flag.name == name; });
  return found == k_missing.end() ? std::string_view() : found->advice;
}

}  // namespace planish::cli
