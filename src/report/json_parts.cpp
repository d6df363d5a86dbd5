#include "report/json_parts.h"

#include <utility>

namespace planish {

namespace {

Json to_json(const std::vector<Problem>& problems) {
  Json list = Json::array();
  for (const Problem& problem : problems) {
    list.push_back({{"code", to_string(problem.code)},
                    {"message", problem.message},
                    {"count", problem.count},
                    {"first", problem.first}});
  }
  return list;
}

Json to_json(const std::optional<Obstruction>& obstruction) {
  if (!obstruction) return nullptr;
  return {{"blocked", obstruction->blocked()},
          {"area", obstruction->area},
          {"border_length", obstruction->border_length},
          {"area_limit", obstruction->area_limit},
          {"area_excess", obstruction->area_excess},
          {"excess_share", obstruction->excess_share},
          {"flat_border", obstruction->has_flat_border()},
          {"total_defect", obstruction->total_defect},
          {"border_turning", obstruction->border_turning},
          {"turning_needed", k_flat_turning},
          {"turning_most", obstruction->turning_most},
          {"border_vertices", obstruction->border_vertices},
          {"fixed_angles", obstruction->fixed_angles}};
}

Json to_json(const SelfIntersections& found) {
  return found.complete ? Json(found.pairs) : Json(nullptr);
}

Json to_json(const StrainAsDesigned& strain) {
  Json json = to_json(strain.least_stretch);
  json["smallest_limit"] = strain.smallest_limit ? Json(*strain.smallest_limit) : Json(nullptr);
  return json;
}

}  // namespace

Json to_json(const Deviation& deviation) {
  return {{"rms", deviation.rms},
          {"max", deviation.max},
          {"rms_over_diagonal", deviation.rms_over_diagonal}};
}

Json to_json(const EdgeStrain& strain) {
  return {{"max", strain.max},
          {"rms", strain.rms},
          {"p99", strain.p99},
          {"stretch", {{"max", strain.max_stretch}, {"p99", strain.p99_stretch}}},
          {"compression", {{"max", strain.max_compression}, {"p99", strain.p99_compression}}}};
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

Json to_json(std::span<const Caution> cautions, Unit unit) {
  Json list = Json::array();
  for (const Caution& caution : cautions) {
    Json json = {{"code", code_of(caution)}, {"message", caution_text(caution, unit)}};
    const auto add = [&](const char* name, double value) { json[name] = value; };
    std::visit([&](const auto& found) { describe(found, add); }, caution);
    list.push_back(std::move(json));
  }
  return list;
}

Json to_json(const std::optional<Overlap>& overlap) {
  if (!overlap) return nullptr;
  return {{"low", {overlap->low.x, overlap->low.y}},
          {"high", {overlap->high.x, overlap->high.y}},
          {"crossings", overlap->crossings}};
}

Json to_json(const std::optional<OpenedCrossings>& opened) {
  if (!opened) return nullptr;
  return {{"crossings", opened->crossings},
          {"largest_move", opened->largest_move},
          {"vertex", opened->vertex}};
}

Json to_json(const UnfoldReport& report) {
  const Pattern& pattern = report.pattern;
  return {{"strain", to_json(report.strain)},
          {"area_ratio", pattern.area_ratio},
          {"flipped_triangles", pattern.flipped_triangles},
          {"overlaps", pattern.overlaps},
          {"overlap", to_json(report.overlap)},
          {"opened", to_json(pattern.opened)},
          {"width", pattern.width},
          {"height", pattern.height},
          {"unit", to_string(report.unit)},
          {"side", "outer"},
          {"turned", report.turned},
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

Json to_json(const Outcome& outcome) {
  Json missed = Json::array();
  for (const Criterion what : outcome.missed)
    missed.push_back(to_string(what));
  return {{"limits_met", outcome.limits_met()},
          {"usable", outcome.usable()},
          {"missed", std::move(missed)}};
}

Json to_json(const MeasuredPatch& patch) {
  const Topology& topology = patch.inspection.topology;
  const Flattenability& figures = patch.figures;
  return {{"vertices", topology.vertices},
          {"triangles", topology.triangles},
          {"inner_vertices", topology.inner_vertices},
          {"components", topology.components},
          {"boundary_loops", topology.border_loops},
          {"euler_characteristic", topology.euler_characteristic},
          {"e_max", figures.e_max},
          {"e_avg", figures.e_avg},
          {"energy", figures.energy},
          {"sum_abs_defect", figures.sum_abs_defect},
          {"min_angle", figures.min_angle},
          {"roughness", figures.roughness},
          {"flattenable", patch.flattenable},
          {"extent", {patch.size.extent.x, patch.size.extent.y, patch.size.extent.z}},
          {"area", patch.size.area},
          {"border_length", patch.size.border_length},
          {"bending", patch.bending.bending},
          {"mean_curvature", patch.bending.mean_curvature},
          {"ruling_defect", patch.ruling_defect},
          {"self_intersections", to_json(patch.self_intersections)},
          {"obstruction", to_json(patch.obstruction)},
          {"problems", to_json(patch.inspection.problems)}};
}

Json strain_and_limits(const std::optional<StrainAsDesigned>& strain) {
  return {{"strain", strain ? to_json(*strain) : Json(nullptr)},
          {"limits", to_json(strain ? strain->limits : std::vector<StrainLimitCheck>{})}};
}

}  // namespace planish
