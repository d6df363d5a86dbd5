#include <charconv>

#include <planish/report/strain_check.h>

namespace planish {

namespace {

std::string rounded(double value, int digits) {
  char text[40];
  const auto end =
      std::to_chars(text, text + sizeof text, value, std::chars_format::general, digits).ptr;
  return {text, end};
}

std::string percent(double share, int digits) {
  return rounded(100.0 * share, digits) + " %";
}

/// So many digits that limit and strain do not read the same where one is above the other.
int digits_for(double limit, double strain) {
  int digits = 3;
  while (strain > limit && digits < 16 && rounded(strain, digits) == rounded(limit, digits))
    ++digits;
  return digits;
}

std::string place_text(const StrainCheck& check) {
  return "from vertex " + std::to_string(check.edge[0]) + " to " + std::to_string(check.edge[1]) +
         ", near (" + rounded(check.at.x, 4) + ", " + rounded(check.at.y, 4) + ", " +
         rounded(check.at.z, 4) + ")";
}

}  // namespace

std::optional<StrainCheck> check_strain(const FlattenReport& report) {
  const auto* options = std::get_if<Auto>(&report.evolve.method);
  if (options == nullptr || !(options->max_strain > 0.0)) return std::nullopt;
  const EdgeStrain& strain = report.unfold.strain;
  const auto& positions = report.processed.positions;
  return StrainCheck{options->max_strain, strain.max, strain.worst_edge,
                     0.5 * (positions[strain.worst_edge[0]] + positions[strain.worst_edge[1]])};
}

std::string check_text(const StrainCheck& check) {
  const int digits = digits_for(check.max_strain, check.largest_strain);
  const std::string limit = percent(check.max_strain, digits);
  const std::string largest = percent(check.largest_strain, digits);
  if (check.met()) {
    return "The strain limit of " + limit + " is met: the pattern's largest strain is " + largest +
           ".";
  }
  return "The strain limit of " + limit + " is not met: the pattern's largest strain is " +
         largest + ", at the edge " + place_text(check) + ".";
}

std::optional<RmsStrainCheck> check_rms_strain(const FlattenReport& report) {
  const auto* options = std::get_if<Auto>(&report.evolve.method);
  if (options == nullptr || !(options->max_rms_strain > 0.0)) return std::nullopt;
  return RmsStrainCheck{options->max_rms_strain, report.unfold.strain.rms};
}

std::string check_text(const RmsStrainCheck& check) {
  const int digits = digits_for(check.max_rms_strain, check.rms_strain);
  return "The limit of " + percent(check.max_rms_strain, digits) +
         " for the rms of the strain is " + (check.met() ? "met" : "not met") +
         ": the pattern's is " + percent(check.rms_strain, digits) + ".";
}

std::string strain_limits_text(const FlattenReport& report) {
  const auto largest = check_strain(report);
  const auto rms = check_rms_strain(report);
  return (largest ? check_text(*largest) : "") + (largest && rms ? " " : "") +
         (rms ? check_text(*rms) : "");
}

}  // namespace planish
