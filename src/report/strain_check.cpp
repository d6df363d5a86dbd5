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
int digits_for(const StrainCheck& check) {
  int digits = 3;
  while (!check.met() && digits < 16 &&
         rounded(check.largest_strain, digits) == rounded(check.max_strain, digits))
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
  const int digits = digits_for(check);
  const std::string limit = percent(check.max_strain, digits);
  const std::string largest = percent(check.largest_strain, digits);
  if (check.met()) {
    return "The strain limit of " + limit + " is met: the pattern's largest strain is " + largest +
           ".";
  }
  return "The strain limit of " + limit + " is not met: the pattern's largest strain is " +
         largest + ", at the edge " + place_text(check) + ".";
}

}  // namespace planish
