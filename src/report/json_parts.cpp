#include "report/json_parts.h"

namespace planish {

Json to_json(const Deviation& deviation) {
  return {{"rms", deviation.rms},
          {"max", deviation.max},
          {"rms_over_diagonal", deviation.rms_over_diagonal}};
}

Json to_json(const EdgeStrain& strain) {
  return {{"max", strain.max}, {"rms", strain.rms}, {"p99", strain.p99}};
}

Json to_json(const std::optional<EdgeStrain>& strain) {
  return strain ? to_json(*strain) : Json(nullptr);
}

Json to_json(const std::vector<StrainLimitCheck>& checks) {
  Json list = Json::array();
  for (const StrainLimitCheck& check : checks) {
    list.push_back(
        {{"kind", to_string(check.kind)},
         {"asked", check.asked},
         {"kept", check.kept()},
         {"reached", check.reached},
         {"share_beyond", check.share_beyond},
         {"where", {{"edge", check.edge}, {"at", {check.at.x, check.at.y, check.at.z}}}}});
  }
  return list;
}

Json to_json(const UnfoldReport& report) {
  const Pattern& pattern = report.pattern;
  return {{"strain", to_json(report.strain)},
          {"area_ratio", pattern.area_ratio},
          {"flipped_triangles", pattern.flipped_triangles},
          {"overlaps", pattern.overlaps},
          {"width", pattern.width},
          {"height", pattern.height},
          {"unit", to_string(report.unit)},
          {"iterations", pattern.iterations},
          {"converged", pattern.converged},
          {"border_strain", report.border_strain},
          {"match_seams", report.unmatched_strain.has_value()},
          {"unmatched_strain", to_json(report.unmatched_strain)},
          {"unlimited_strain", to_json(report.unlimited_strain)},
          {"limits", to_json(report.limits)}};
}

Json to_json(const Failure& failure) {
  return {{"code", failure.code}, {"message", failure.message}};
}

Json to_json(const TwinOf& twin) {
  return {{"of", twin.name}, {"mirrored", twin.mirrored}};
}

}  // namespace planish
