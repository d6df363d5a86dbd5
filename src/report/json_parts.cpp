#include "report/json_parts.h"

#include <utility>

namespace planish {

namespace {

Json to_json(const SelfIntersections& found) {
  return found.complete ? Json(found.pairs) : Json(nullptr);
}

}  // namespace

void to_json(Json& json, Vec2 at) {
  json = {at.x, at.y};
}

void to_json(Json& json, Vec3 at) {
  json = {at.x, at.y, at.z};
}

void to_json(Json& json, const Problem& problem) {
  json = {{"code", to_string(problem.code)},
          {"message", problem.message},
          {"count", problem.count},
          {"first", problem.first}};
}

void to_json(Json& json, const Obstruction& obstruction) {
  json = {{"blocked", obstruction.blocked()},
          {"area", obstruction.area},
          {"border_length", obstruction.border_length},
          {"area_limit", obstruction.area_limit},
          {"area_excess", obstruction.area_excess},
          {"excess_share", obstruction.excess_share},
          {"flat_border", obstruction.has_flat_border()},
          {"total_defect", obstruction.total_defect},
          {"border_turning", obstruction.border_turning},
          {"turning_needed", k_flat_turning},
          {"turning_most", obstruction.turning_most},
          {"border_vertices", obstruction.border_vertices},
          {"fixed_angles", obstruction.fixed_angles}};
}

void to_json(Json& json, const StrainAsDesigned& strain) {
  json = strain.least_stretch;
  json["smallest_limit"] = strain.smallest_limit;
}

void to_json(Json& json, const Deviation& deviation) {
  json = {{"rms", deviation.rms},
          {"max", deviation.max},
          {"rms_over_diagonal", deviation.rms_over_diagonal}};
}

void to_json(Json& json, const EdgeStrain& strain) {
  json = {{"max", strain.max},
          {"rms", strain.rms},
          {"p99", strain.p99},
          {"stretch", {{"max", strain.max_stretch}, {"p99", strain.p99_stretch}}},
          {"compression", {{"max", strain.max_compression}, {"p99", strain.p99_compression}}}};
}

void to_json(Json& json, const LimitCheck& check) {
  json = {{"kind", figure_name(check.what)},
          {"asked", check.limit},
          {"kept", check.met},
          {"reached", check.value},
          {"share_beyond", check.share_beyond},
          {"where", {{"edge", check.edge}, {"at", check.at}}}};
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

void to_json(Json& json, const Overlap& overlap) {
  json = {{"low", overlap.low}, {"high", overlap.high}, {"crossings", overlap.crossings}};
}

void to_json(Json& json, const OpenedCrossings& opened) {
  json = {{"crossings", opened.crossings},
          {"largest_move", opened.largest_move},
          {"vertex", opened.vertex}};
}

void to_json(Json& json, const PatternHoles& holes) {
  json = {{"count", holes.count}, {"longest", holes.longest}};
}

void to_json(Json& json, const UnfoldReport& report) {
  const Pattern& pattern = report.pattern;
  json = {{"strain", report.strain},
          {"area_ratio", pattern.area_ratio},
          {"flipped_triangles", pattern.flipped_triangles},
          {"overlaps", pattern.overlaps},
          {"overlap", report.overlap},
          {"opened", pattern.opened},
          {"holes", pattern.holes},
          {"width", pattern.width},
          {"height", pattern.height},
          {"unit", to_string(report.unit)},
          {"side", "outer"},
          {"turned", report.turned},
          {"iterations", pattern.iterations},
          {"converged", pattern.converged},
          {"border_strain", report.border_strain},
          {"match_seams", report.unmatched_strain.has_value()},
          {"unmatched_strain", report.unmatched_strain},
          {"unlimited_strain", report.unlimited_strain},
          {"limits", report.limits}};
}

void to_json(Json& json, const Failure& failure) {
  json = {{"code", failure.code}, {"message", failure.message}};
}

void to_json(Json& json, const TwinOf& twin) {
  json = {{"of", twin.name}, {"mirrored", twin.mirrored}};
}

void to_json(Json& json, const Outcome& outcome) {
  Json missed = Json::array();
  for (const Criterion what : outcome.missed)
    missed.push_back(to_string(what));
  json = {{"limits_met", outcome.limits_met()},
          {"usable", outcome.usable()},
          {"missed", std::move(missed)}};
}

void to_json(Json& json, const MeasuredPatch& patch) {
  const Topology& topology = patch.inspection.topology;
  const Flattenability& figures = patch.figures;
  json = {{"vertices", topology.vertices},
          {"triangles", topology.triangles},
          {"inner_vertices", topology.inner_vertices},
          {"components", topology.components},
          {"boundary_loops", topology.border_loops},
          {"euler_characteristic", topology.euler_characteristic},
          {"e_max", figures.e_max},
          {"e_avg", figures.e_avg},
          {"energy", figures.energy},
          {"sum_abs_defect", figures.sum_abs_defect},
          {"hole_turning", figures.hole_turning},
          {"hole_gap", figures.hole_gap},
          {"min_angle", figures.min_angle},
          {"roughness", figures.roughness},
          {"flattenable", patch.flattenable},
          {"extent", patch.size.extent},
          {"area", patch.size.area},
          {"border_length", patch.size.border_length},
          {"bending", patch.bending.bending},
          {"mean_curvature", patch.bending.mean_curvature},
          {"ruling_defect", patch.ruling_defect},
          {"self_intersections", to_json(patch.self_intersections)},
          {"obstruction", patch.obstruction},
          {"problems", patch.inspection.problems}};
}

Json strain_and_limits(const std::optional<StrainAsDesigned>& strain) {
  return {{"strain", strain}, {"limits", strain ? Json(strain->limits) : Json::array()}};
}

}  // namespace planish
