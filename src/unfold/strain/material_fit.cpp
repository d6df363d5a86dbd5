#include <optional>

#include <planish/unfold/material_fit.h>

namespace planish {

namespace {

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
  const StrainLimits limits = limits_of(material);
  MaterialVerdict verdict{.material = &material, .takes = limits.kept_by(strain)};
  double most = -1.0;
  for (const StrainLimitKind kind : k_strain_limit_kinds) {
    if (limits.of(kind) == 0.0) continue;
    const double share = figure_of(strain, kind) / limits.of(kind);
    if (share <= most) continue;
    most = share;
    verdict.tightest = kind;
    verdict.limit = limits.of(kind);
    verdict.strain = figure_of(strain, kind);
  }
  return verdict;
}

}  // namespace

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
