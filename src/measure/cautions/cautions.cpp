#include <cmath>

#include <planish/measure/cautions.h>

#include "core/figure_text.h"

namespace planish {

namespace {

/// "0.5", "6.4", "22.5": one digit after the point, and that only where it is not 0.
std::string short_text(double value) {
  return decimals_text(value, std::abs(value - std::round(value)) < 0.05 ? 0 : 1);
}

std::string text_of(const HiddenCurvature& caution, Unit) {
  const std::string start =
      caution.inner_share == 0.0
          ? "No vertex is inside the mesh"
          : "Only " + percent_text(caution.inner_share) + " of the area is around inner vertices";
  return start +
         ", so double curvature cannot show: mesh the surface finer, with several rows of facets "
         "across.";
}

std::string text_of(const CoarseCoordinates& caution, Unit unit) {
  return "The coordinates step by " + length_text(caution.step, unit) +
         " where the mean edge has " + length_text(caution.mean_edge, unit) + ", " +
         percent_text(caution.step / caution.mean_edge) +
         " of it: lengths are wrong by about as much. Move the model to the origin in the program "
         "that made it, and export it again.";
}

std::string text_of(const CoarseFacets& caution, Unit) {
  return "Facets turn by " + short_text(caution.turn) + " degrees: up to " +
         short_text(1000.0 * caution.shortening) +
         "\u00A0mm per metre short where the surface is meant to be round. Mesh it finer.";
}

/// As the flag takes it: in millimetres, or inches of a model in inches.
std::string smoothing_length(double wave, Unit unit) {
  const bool in_inches = unit == Unit::in;
  return significant_text(in_inches ? wave : millimetres_per(unit) * wave, 2) +
         (in_inches ? "in" : "mm");
}

std::string text_of(const ScanNoise& caution, Unit unit) {
  return "The short waves of the surface look like noise, of " +
         length_text(caution.amplitude, unit) +
         " as a rule, and make it larger than it is: --smooth-first " +
         smoothing_length(caution.wave, unit) + " takes them out, but not along the border.";
}

}  // namespace

std::vector<Caution> find_cautions(const Patch& patch) {
  std::vector<Caution> cautions;
  const auto add = [&](const auto& found) {
    if (found) cautions.emplace_back(*found);
    return found.has_value();
  };
  add(find_hidden_curvature(patch));
  add(find_coarse_coordinates(patch));
  if (!add(find_scan_noise(patch))) add(find_coarse_facets(patch));
  return cautions;
}

std::vector<Caution> find_cautions(const Patch& raw, const Patch& smoothed) {
  std::vector<Caution> cautions = find_cautions(smoothed);
  if (const auto rounded = find_coarse_coordinates(raw)) cautions.emplace_back(*rounded);
  return cautions;
}

std::string_view code_of(const Caution& caution) {
  struct Code {
    std::string_view operator()(const HiddenCurvature&) const { return "hidden_curvature"; }
    std::string_view operator()(const CoarseCoordinates&) const { return "coarse_coordinates"; }
    std::string_view operator()(const CoarseFacets&) const { return "coarse_facets"; }
    std::string_view operator()(const ScanNoise&) const { return "scan_noise"; }
  };
  return std::visit(Code{}, caution);
}

std::string_view words_of(const Caution& caution) {
  struct Words {
    std::string_view operator()(const HiddenCurvature& hidden) const {
      return hidden.inner_share == 0.0 ? "no vertex inside" : "too few vertices inside";
    }
    std::string_view operator()(const CoarseCoordinates&) const { return "coarse coordinates"; }
    std::string_view operator()(const CoarseFacets&) const { return "coarse facets"; }
    std::string_view operator()(const ScanNoise&) const { return "looks like a noisy scan"; }
  };
  return std::visit(Words{}, caution);
}

std::string words_of(std::span<const Caution> cautions) {
  std::string words;
  for (const Caution& caution : cautions)
    words += (words.empty() ? "" : ", ") + std::string(words_of(caution));
  return words;
}

std::string caution_text(const Caution& caution, Unit unit) {
  return std::visit([unit](const auto& found) { return text_of(found, unit); }, caution);
}

const Caution* unjudged_by(std::span<const Caution> cautions, bool is_mesh_flat) {
  for (const Caution& caution : cautions) {
    if ((is_mesh_flat && std::holds_alternative<HiddenCurvature>(caution)) ||
        std::holds_alternative<CoarseCoordinates>(caution))
      return &caution;
  }
  return nullptr;
}

}  // namespace planish
