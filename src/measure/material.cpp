#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include <planish/core/error.h>
#include <planish/measure/material.h>

namespace planish {

namespace {

constexpr const char* k_fitting =
    "guide value of Zhang, Wang and Ramani 2016, Optimal fitting of strain-controlled flattenable "
    "mesh surfaces";

/// What gives as far in both ways.
Material alike(std::string name, std::string use, double strain, const std::string& source) {
  const MaterialLimit limit = {{strain, source}};
  return {std::move(name), std::move(use), limit, limit};
}

Material leather_lasted() {
  // A cone of 7 mm over a disc of 12.5 mm radius is 14.6 % longer than the disc: 12.7 % of itself.
  const MaterialFigure grain_crack = {
      0.12,
      "ISO 3379 (lastometer: a disc 25 mm across is pushed up in its middle); upper leather is to "
      "reach 7 mm before its grain cracks (UNIDO 1996, Acceptable quality standards in the leather "
      "and footwear industry): as a cone 14.6 % of the sheet, 12.7 % of the form"};
  const MaterialFigure as_flat = {0.01, std::string("as leather for flat work: ") + k_fitting};
  return {"leather-lasted",
          "upper leather pulled over a last, which sets it",
          {grain_crack, grain_crack},
          {as_flat}};
}

Material stretch_woven() {
  const MaterialFigure stretch = {
      0.107,
      "ASTM D3107 is for cloth of stretch yarns that gives more than 12 % at up to 360 g/cm: 12 % "
      "of the sheet are 10.7 % of the form"};
  const MaterialFigure as_cotton = {0.05, std::string("as cotton: ") + k_fitting};
  return {"stretch-woven", "woven cloth of stretch yarns, along these", {stretch}, {as_cotton}};
}

std::vector<Material> made() {
  return {
      alike("steel", "sheet steel that is bent and not beaten", 0.002,
            "lasting strain at the 0.2 % proof strength of sheet steel, EN 10130"),
      alike("aluminium", "sheet aluminium that is bent and not beaten", 0.002,
            "lasting strain at the 0.2 % proof strength of sheet aluminium, EN 485-2"),
      alike("leather", "leather for flat work; leather-lasted for uppers", 0.01, k_fitting),
      alike("cotton", "cotton cloth", 0.05, k_fitting),
      alike("neoprene", "neoprene, as of wetsuits", 0.10, k_fitting),
      stretch_woven(),
      leather_lasted(),
  };
}

/// Sets a limit of both ways where they are equal, else one of each that is there.
void set_limits(double& both, double& stretch, double& compression,
                const std::optional<MaterialFigure>& stretched,
                const std::optional<MaterialFigure>& compressed) {
  if (stretched && compressed && stretched->strain == compressed->strain) {
    both = stretched->strain;
    return;
  }
  if (stretched) stretch = stretched->strain;
  if (compressed) compression = compressed->strain;
}

MaterialVerdict verdict_of(const Material& material, const EdgeStrain& strain) {
  const std::vector<LimitCheck> checks = check_limits(strain, limits_of(material));
  const auto tightest =
      std::max_element(checks.begin(), checks.end(), [](const LimitCheck& a, const LimitCheck& b) {
        return a.value / a.limit < b.value / b.limit;
      });
  return {&material, all_kept(checks), tightest == checks.end() ? LimitCheck{} : *tightest};
}

}  // namespace

std::span<const Material> materials() {
  static const std::vector<Material> all = made();
  return all;
}

std::vector<std::string> material_names() {
  std::vector<std::string> names;
  for (const Material& material : materials())
    names.push_back(material.name);
  return names;
}

const Material& material_named(std::string_view name) {
  std::string known;
  for (const Material& material : materials()) {
    if (material.name == name) return material;
    known += (known.empty() ? "" : ", ") + material.name;
  }
  throw Error(ErrorCode::unknown_name,
              "no material is called \"" + std::string(name) + "\"; known are " + known);
}

StrainLimits limits_of(const Material& material) {
  StrainLimits limits;
  set_limits(limits.p99, limits.p99_stretch, limits.p99_compression, material.stretch.usual,
             material.compression.usual);
  set_limits(limits.max, limits.max_stretch, limits.max_compression, material.stretch.largest,
             material.compression.largest);
  return limits;
}

std::vector<MaterialVerdict> materials_for(const EdgeStrain& strain) {
  std::vector<MaterialVerdict> verdicts;
  for (const Material& material : materials())
    verdicts.push_back(verdict_of(material, strain));
  return verdicts;
}

}  // namespace planish
