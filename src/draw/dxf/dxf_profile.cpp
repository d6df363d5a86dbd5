#include "draw/dxf/dxf_profile.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include <planish/core/error.h>

#include "draw/dxf/dxf_tags.h"

namespace planish {

namespace {

constexpr std::array<DxfDialect, k_dxf_profiles.size()> k_dialects = {{
    {DxfProfile::generic, "generic", DxfFamily::none},
    {DxfProfile::aama, "aama", DxfFamily::aama},
    {DxfProfile::astm, "astm", DxfFamily::astm},
    {DxfProfile::clo, "clo", DxfFamily::aama, "AC1006", true},
    {DxfProfile::lectra, "lectra", DxfFamily::aama},
    {DxfProfile::optitex, "optitex", DxfFamily::astm},
    {DxfProfile::gerber, "gerber", DxfFamily::astm, {}, false, "Fabric"},
}};

// Our names for what the layers of apparel CAD are for.
constexpr std::pair<std::string_view, std::string_view> k_numbers[] = {
    {"cut", k_boundary_layer}, {"notch", "4"}, {"fold", "6"},   {"grain", "7"},
    {"internal", "8"},         {"hole", "11"}, {"drill", "13"}, {"seam", "14"},
};

std::optional<std::string> number_of(std::string_view layer) {
  const auto* const found = std::find_if(std::begin(k_numbers), std::end(k_numbers),
                                         [&](const auto& entry) { return entry.first == layer; });
  if (found == std::end(k_numbers)) return std::nullopt;
  return std::string(found->second);
}

}  // namespace

void check_layer_names(const Drawing& drawing, const DxfOptions& options) {
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

std::string_view to_string(DxfVersion version) {
  return version == DxfVersion::r12 ? "r12" : "r2000";
}

std::optional<std::string> dxf_layer_name(std::string_view layer, const DxfOptions& options) {
  const auto renamed = options.layer_names.find(layer);
  if (renamed != options.layer_names.end()) return dxf_name(renamed->second);
  if (dialect_of(options.profile).family != DxfFamily::none) return number_of(layer);
  return dxf_name(layer);
}

}  // namespace planish
