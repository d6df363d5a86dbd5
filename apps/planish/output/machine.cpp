#include "output/machine.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

#include "output/pattern_output.h"
#include "shell/failures.h"
#include "shell/values.h"

namespace planish::cli {

namespace {

constexpr const char* k_flag = "--for";

struct Preset {
  std::string_view flag, value;
};

/// What a machine, or a program, takes.
struct Machine {
  std::string_view name;
  std::vector<PatternFormat> formats;  ///< the usual ones first
  std::vector<Preset> flags;
};

const std::vector<Machine>& machines() {
  using enum PatternFormat;
  constexpr std::string_view k_cut = "cut,hole,notch,drill,internal";
  static const std::vector<Machine> all = {
      {"laser",
       {svg, dxf},
       {{"--only-layers", k_cut}, {"--text", "strokes"}, {"--svg-groups", "pieces"}}},
      {"knife",
       {svg, dxf, plt},
       {{"--only-layers", "cut,hole,notch"}, {"--text", "strokes"}, {"--svg-groups", "pieces"}}},
      {"plotter",
       {plt, pdf},
       {{"--only-layers", "cut,hole,seam,notch,grain,fold,drill,internal,annotation"},
        {"--text", "strokes"}}},
      {"projector",
       {pdf, svg},
       {{"--only-layers", "cut,hole,seam,notch,grain,fold,drill,internal,annotation"}}},
      {"apparel", {dxf}, {{"--dxf-profile", "aama"}}},
  };
  return all;
}

std::vector<std::string> machine_names() {
  std::vector<std::string> names;
  for (const Machine& machine : machines())
    names.emplace_back(machine.name);
  return names;
}

bool has_format(const std::vector<PatternFormat>& formats, PatternFormat format) {
  return std::find(formats.begin(), formats.end(), format) != formats.end();
}

/// Whether a flag changes any of the formats that are written.
bool has_effect(std::string_view flag, const std::vector<PatternFormat>& written) {
  if (flag.starts_with("--dxf")) return has_format(written, PatternFormat::dxf);
  if (flag.starts_with("--svg")) return has_format(written, PatternFormat::svg);
  return true;
}

std::string list_of_formats(const std::vector<PatternFormat>& formats) {
  return list_of(names_of(formats));
}

}  // namespace

Flag machine_flag() {
  return {k_flag,
          "KIND",
          "what the files are for: " + list_of(machine_names()) +
              "; sets formats, layers and more, which your other flags can change",
          0,
          false,
          {.choices = machine_names()}};
}

Arguments with_machine(const Arguments& arguments, const std::string& output) {
  if (!arguments.has(k_flag)) return arguments;
  const std::string name = known_name("kind of machine", arguments.text(k_flag), machine_names());
  const Machine& machine = *std::find_if(machines().begin(), machines().end(),
                                         [&](const Machine& some) { return some.name == name; });
  Arguments some = arguments;
  std::vector<PatternFormat> written = machine.formats;
  if (!output.empty()) {
    const auto format = pattern_format_of(output);
    written = format ? std::vector{*format} : std::vector<PatternFormat>{};
  } else if (arguments.has("--formats")) {
    written = formats_from(arguments);
  } else {
    some.flags["--formats"].clear();
    for (const PatternFormat format : written)
      some.flags["--formats"].emplace_back(std::string(to_string(format)));
  }
  const bool is_for_it = std::any_of(written.begin(), written.end(), [&](PatternFormat format) {
    return has_format(machine.formats, format);
  });
  if (!is_for_it) {
    throw UsageError("--for " + name + " goes with " + list_of_formats(machine.formats) + " only");
  }
  for (const Preset& preset : machine.flags) {
    const std::string flag(preset.flag);
    if (!arguments.has(flag) && has_effect(flag, written))
      some.flags[flag] = {std::string(preset.value)};
  }
  return some;
}

bool has_layers_of_machine(const Arguments& arguments) {
  const std::string name = arguments.text(k_flag), layers = arguments.text("--only-layers");
  for (const Machine& machine : machines()) {
    if (machine.name != name) continue;
    return std::any_of(machine.flags.begin(), machine.flags.end(), [&](const Preset& preset) {
      return preset.flag == "--only-layers" && preset.value == layers;
    });
  }
  return false;
}

}  // namespace planish::cli
