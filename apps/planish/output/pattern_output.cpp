#include "output/pattern_output.h"

#include <algorithm>
#include <array>
#include <limits>

#include <planish/draw/format_drawing.h>
#include <planish/sheet/pattern_sheet.h>

#include "draw/text/stroke_text.h"
#include "flags/annotation_flags.h"
#include "flags/quantities.h"
#include "flags/units.h"
#include "output/machine.h"
#include "shell/failures.h"
#include "shell/file_name.h"
#include "shell/nearest.h"
#include "shell/values.h"

namespace planish::cli {

namespace {

constexpr std::array k_formats = {PatternFormat::svg, PatternFormat::dxf, PatternFormat::pdf,
                                  PatternFormat::plt};
constexpr const char* k_usual_formats = "svg,dxf,pdf";

std::vector<std::string> layer_names() {
  return {k_sheet_layers.begin(), k_sheet_layers.end()};
}

/// "cut,notch"
/// @throws UsageError, Error unknown_name
std::vector<std::string> only_layers_from(const Arguments& arguments) {
  std::vector<std::string> wanted;
  if (!arguments.has("--only-layers")) return wanted;
  const std::vector<std::string> layers = layer_names();
  for (const Field& field : arguments.fields("--only-layers")) {
    const std::string name = field_text(field);
    const auto found = std::find_if(layers.begin(), layers.end(), [&](const std::string& layer) {
      return same_word(layer, name);
    });
    if (found == layers.end()) {
      throw Error(ErrorCode::unknown_name, "--only-layers has \"" + name + "\", which is no layer" +
                                               nearest_hint(name, layers) + " (there are " +
                                               list_of(layers) + ")");
    }
    if ((*found == "strain" || *found == "legend") && !arguments.has("--map"))
      throw UsageError("the layer " + *found + " of --only-layers is drawn with --map only");
    wanted.push_back(*found);
  }
  return wanted;
}

// "cut=LASER,label=NOTES"
std::map<std::string, std::string, std::less<>> layer_names_from(const Arguments& arguments) {
  const std::vector<std::string> layers = layer_names();
  std::map<std::string, std::string, std::less<>> names;
  for (const Field& field : arguments.fields("--dxf-layers")) {
    const std::string pair = field_text(field);
    const std::size_t sign = pair.find('=');
    if (sign == std::string::npos || sign + 1 == pair.size()) {
      throw UsageError("--dxf-layers has \"" + pair + "\" but must be like cut=LASER,label=NOTES");
    }
    names[known_name("layer", pair.substr(0, sign), layers)] = pair.substr(sign + 1);
  }
  return names;
}

std::vector<std::string> paper_names() {
  std::vector<std::string> names;
  for (const Paper& paper : papers())
    names.push_back(paper.name);
  return names;
}

/// One with a name, or as "36inx48in" one of its own size.
Paper paper_from(const Arguments& arguments) {
  const std::string text = arguments.text("--paper");
  const std::size_t sign = text.find('x', 1);
  const bool is_size = !text.empty() && text.find_first_of("0123456789") == 0;
  if (!is_size || sign == std::string::npos)
    return paper_named(known_name("paper", text, paper_names()));
  const auto side = [&](const std::string& length) {
    if (length.find_first_not_of("0123456789.") == std::string::npos) {
      throw UsageError("--paper is \"" + text + "\" but needs units, as 36inx48in or 900mmx1200mm");
    }
    constexpr Range range = {.min = std::numeric_limits<double>::min(), .max = 1e7};
    return millimetres_per(unit_from(arguments)) *
           quantity_value("--paper", length, Quantity::length, range, arguments);
  };
  const double one = side(text.substr(0, sign)), other = side(text.substr(sign + 1));
  return {text, std::min(one, other), std::max(one, other)};
}

/// @throws UsageError, Error option_out_of_range
std::optional<PageOptions> pages_from(const Arguments& arguments) {
  if (!arguments.has("--paper")) {
    if (arguments.has("--page-overlap"))
      throw UsageError("flag --page-overlap goes with --paper only");
    return std::nullopt;
  }
  PageOptions pages{.paper = paper_from(arguments)};
  if (arguments.has("--page-overlap")) {
    pages.overlap = millimetres_per(unit_from(arguments)) *
                    quantity_value("--page-overlap", arguments.value("--page-overlap"),
                                   Quantity::length, {.min = 0.0, .max = 1e7}, arguments);
  }
  page_room(pages, false);  // refuses what leaves no room
  return pages;
}

std::vector<std::string> text_kinds() {
  return {"letters", "strokes"};
}

std::vector<std::string> group_kinds() {
  return {"layers", "pieces"};
}

std::vector<std::string> notch_kinds() {
  return {"points", "strokes"};
}

/// The border of a layout stays in HPGL, though it does not show: a machine counts from the corner
/// of the material, not from that of the pieces.
Drawing with_layers(Drawing sheet, PatternFormat format, const std::vector<std::string>& wanted) {
  const bool is_layout = std::none_of(sheet.layers.begin(), sheet.layers.end(),
                                      [](const Layer& layer) { return layer.name == "strain"; });
  for (Layer& layer : sheet.layers)
    layer.visible = std::find(wanted.begin(), wanted.end(), layer.name) != wanted.end();
  std::erase_if(sheet.layers, [&](const Layer& layer) {
    const bool is_border = is_layout && format == PatternFormat::plt && layer.name == "label";
    return !layer.visible && !is_border;
  });
  return sheet;
}

/// What a format shows of the sheet: the strain map, and its legend, on request and where there are
/// areas.
Drawing prepared(Drawing sheet, PatternFormat format, const PatternOutput& output) {
  const bool has_areas = format == PatternFormat::svg || format == PatternFormat::pdf;
  if (!output.map || !has_areas) sheet = without_map(std::move(sheet));
  if (!output.only_layers.empty())
    sheet = with_layers(std::move(sheet), format, output.only_layers);
  return output.stroked_text ? with_stroked_text(std::move(sheet)) : sheet;
}

}  // namespace

std::string_view to_string(PatternFormat format) {
  switch (format) {
    case PatternFormat::svg:
      return "svg";
    case PatternFormat::dxf:
      return "dxf";
    case PatternFormat::pdf:
      return "pdf";
    case PatternFormat::plt:
      return "plt";
  }
  return "unknown";
}

std::optional<PatternFormat> pattern_format_of(const std::string& path) {
  const std::string extension = lower_extension(path);
  for (const PatternFormat format : k_formats) {
    if (extension == "." + std::string(to_string(format))) return format;
  }
  return std::nullopt;
}

std::vector<Flag> pattern_flags(const std::string& paper_doc) {
  return {
      {"--paper",
       "PAPER",
       paper_doc + ": " + list_of(paper_names()) + ", or any size as 36inx48in",
       0,
       false,
       {.type = ValueType::text, .choices = paper_names()}},
      {"--page-overlap",
       "LENGTH",
       "overlap of neighbouring pages of --paper (default 10mm)",
       0,
       false,
       {.range = {.min = 0.0}, .standard = "10mm"}},
      machine_flag(),
      {"--map", "", "draw the strain map and its legend in .svg, .pdf and on the pages of --paper"},
      {"--only-layers",
       "LIST",
       "write only these layers, as cut,notch: any of " + list_of(layer_names()),
       0,
       false,
       {.choices = layer_names()}},
      {"--text",
       "KIND",
       "letters, or strokes for machines that have no letters (default letters)",
       0,
       false,
       {.choices = text_kinds(), .standard = "letters"}},
      {"--svg-groups",
       "KIND",
       "what the groups of the .svg are: layers, or pieces with their layers inside (default "
       "layers)",
       0,
       false,
       {.choices = group_kinds(), .standard = "layers"}},
      {"--dxf-profile",
       "NAME",
       "program that reads the .dxf: " + list_of(names_of(k_dxf_profiles)) + " (default generic)",
       0,
       false,
       {.choices = names_of(k_dxf_profiles), .standard = "generic"}},
      {"--dxf-version",
       "NAME",
       "version of the .dxf: r12, which nearly every program reads, or r2000, with arcs and "
       "splines (default r12)",
       0,
       false,
       {.choices = names_of(k_dxf_versions), .standard = "r12"}},
      {"--dxf-notches",
       "KIND",
       "notches in a .dxf for apparel programs: points, or strokes for cutters that ignore points "
       "(default points)",
       0,
       false,
       {.choices = notch_kinds(), .standard = "points"}},
      {"--dxf-layers", "A=B,...",
       "other names in the .dxf for the layers " + list_of(layer_names())}};
}

PatternOutput pattern_output_from(const Arguments& arguments) {
  PatternOutput output;
  output.stroked_text =
      known_name("kind of text", arguments.text("--text", "letters"), text_kinds()) == "strokes";
  output.dxf.profile = dxf_profile_named(
      known_name("profile", arguments.text("--dxf-profile", "generic"), names_of(k_dxf_profiles)));
  output.svg.by_piece = known_name("kind of groups", arguments.text("--svg-groups", "layers"),
                                   group_kinds()) == "pieces";
  output.map = arguments.has("--map");
  output.only_layers = only_layers_from(arguments);
  output.layers_by_name = !has_layers_of_machine(arguments);
  output.dxf.version =
      value_named("version of DXF", arguments.text("--dxf-version", "r12"), k_dxf_versions);
  output.dxf.notch_strokes =
      known_name("kind of notches", arguments.text("--dxf-notches", "points"), notch_kinds()) ==
      "strokes";
  output.dxf.unit = sheet_unit_from(arguments);
  if (arguments.has("--dxf-layers")) {
    output.dxf.layer_names = layer_names_from(arguments);
  }
  output.pages = pages_from(arguments);
  return output;
}

void refuse_idle_pattern_flags(const Arguments& arguments,
                               const std::vector<PatternFormat>& formats) {
  const auto check = [&](const char* flag, bool is_heeded, const std::string& where) {
    if (arguments.has(flag) && !is_heeded) {
      throw UsageError(std::string("flag ") + flag + " goes with " + where + " only");
    }
  };
  const auto writes = [&](PatternFormat format) {
    return std::find(formats.begin(), formats.end(), format) != formats.end();
  };
  check("--paper", writes(PatternFormat::pdf), "pdf");
  check("--text", !formats.empty(), "svg, dxf, pdf and plt");
  check("--dxf-profile", writes(PatternFormat::dxf), "dxf");
  check("--dxf-layers", writes(PatternFormat::dxf), "dxf");
  check("--svg-groups", writes(PatternFormat::svg), "svg");
  check("--map", writes(PatternFormat::svg) || writes(PatternFormat::pdf), "svg and pdf");
  check("--only-layers", !formats.empty(), "svg, dxf, pdf and plt");
  const bool is_apparel =
      arguments.text("--dxf-profile", "generic") != to_string(DxfProfile::generic);
  check("--dxf-version", writes(PatternFormat::dxf) && !is_apparel, "dxf of the profile generic");
  check("--dxf-notches", writes(PatternFormat::dxf) && is_apparel, "a --dxf-profile for apparel");
}

Flag formats_flag() {
  return {"--formats",
          "LIST",
          std::string("file formats of the pattern: any of svg, dxf, pdf and plt (default ") +
              k_usual_formats + ")",
          0,
          false,
          {.choices = names_of(k_formats), .standard = k_usual_formats}};
}

std::vector<PatternFormat> formats_from(const Arguments& arguments) {
  std::vector<PatternFormat> formats;
  for (const Field& name : arguments.fields("--formats", k_usual_formats)) {
    const PatternFormat format = value_named("format", field_text(name), k_formats);
    if (std::find(formats.begin(), formats.end(), format) == formats.end()) {
      formats.push_back(format);
    }
  }
  return formats;
}

std::string pattern_file(const Drawing& sheet, PatternFormat format, const PatternOutput& output) {
  const Drawing drawing = prepared(sheet, format, output);
  switch (format) {
    case PatternFormat::svg:
      return format_svg(drawing, output.svg);
    case PatternFormat::dxf:
      return format_dxf(drawing, output.dxf);
    case PatternFormat::pdf:
      return format_pdf(drawing);
    case PatternFormat::plt:
      return format_plt(drawing);
  }
  return {};
}

std::string tiled_file(const Drawing& sheet, const PatternOutput& output) {
  return format_tiled_pdf(prepared(sheet, PatternFormat::pdf, output), *output.pages);
}

}  // namespace planish::cli
