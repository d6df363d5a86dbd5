#include "draw/dxf/dxf_profile.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include <planish/core/error.h>

#include "draw/dxf/dxf_tags.h"

namespace planish {

namespace {

constexpr std::string_view k_r10 = "AC1006", k_r12 = "AC1009";
constexpr std::string_view k_aama = "ANSI/AAMA VERSION: 292", k_astm = "ASTM VERSION: D6673";

constexpr std::array<DxfDialect, k_dxf_profiles.size()> k_dialects = {{
    {DxfProfile::generic, "generic", k_r12, false, {}},
    {DxfProfile::aama, "aama", k_r12, true, k_aama},
    {DxfProfile::astm, "astm", k_r12, true, k_astm},
    {DxfProfile::clo, "clo", k_r10, true, k_aama},
    {DxfProfile::lectra, "lectra", k_r12, true, k_aama},
    {DxfProfile::optitex, "optitex", k_r12, true, k_astm},
    {DxfProfile::gerber, "gerber", k_r12, true, k_astm},
}};

// Our names for what the layers of apparel CAD are for.
constexpr std::pair<std::string_view, std::string_view> k_numbers[] = {
    {"cut", k_boundary_layer}, {"notch", "4"}, {"grain", "7"},       {"internal", "8"},
    {"drill", "13"},           {"seam", "14"}, {"annotation", "15"},
};

std::optional<std::string> number_of(const std::string& layer) {
  const auto* const found = std::find_if(std::begin(k_numbers), std::end(k_numbers),
                                         [&](const auto& entry) { return entry.first == layer; });
  if (found == std::end(k_numbers)) return std::nullopt;
  return std::string(found->second);
}

void check_names(const Drawing& drawing, const DxfOptions& options) {
  for (const auto& [name, other] : options.layer_names) {
    const auto is_it = [&, &wanted = name](const Layer& layer) { return layer.name == wanted; };
    if (std::any_of(drawing.layers.begin(), drawing.layers.end(), is_it)) continue;
    std::string known;
    for (const Layer& layer : drawing.layers)
      known += (known.empty() ? "" : ", ") + layer.name;
    throw Error(ErrorCode::unknown_name,
                "the drawing has no layer called '" + name + "'; there are " + known);
  }
}

}  // namespace

const DxfDialect& dialect_of(DxfProfile profile) {
  return k_dialects[static_cast<std::size_t>(profile)];
}

std::string_view to_string(DxfProfile profile) {
  return dialect_of(profile).name;
}

DxfProfile dxf_profile_named(std::string_view name) {
  std::string known;
  for (const DxfDialect& dialect : k_dialects) {
    if (dialect.name == name) return dialect.profile;
    known += (known.empty() ? "" : ", ") + std::string(dialect.name);
  }
  throw Error(ErrorCode::unknown_name,
              "no profile is called '" + std::string(name) + "'; there are " + known);
}

std::vector<std::optional<std::string>> dxf_layer_names(const Drawing& drawing,
                                                        const DxfOptions& options) {
  check_names(drawing, options);
  const bool by_number = dialect_of(options.profile).has_pieces;
  std::vector<std::optional<std::string>> names;
  names.reserve(drawing.layers.size());
  for (const Layer& layer : drawing.layers) {
    const auto renamed = options.layer_names.find(layer.name);
    if (renamed != options.layer_names.end()) {
      names.emplace_back(dxf_name(renamed->second));
    } else {
      names.push_back(by_number ? number_of(layer.name) : dxf_name(layer.name));
    }
  }
  return names;
}

}  // namespace planish
