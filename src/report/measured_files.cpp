#include "report/measured_files.h"

#include <cmath>
#include <initializer_list>
#include <utility>

#include <planish/core/version.h>

#include "core/number_text.h"
#include "report/json_parts.h"

namespace planish {

namespace {

/// In quotes where a comma, a quote or a line end would break the line.
std::string csv_text(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text)
    quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

/// Empty where it is not known or not finite.
std::string csv_number(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? number_text(*value) : std::string();
}

std::string joined(std::initializer_list<std::string> cells) {
  std::string line;
  for (const std::string& cell : cells)
    line += cell + ',';
  line.pop_back();
  return line;
}

constexpr const char* k_patch_columns =
    "vertices,triangles,inner_vertices,components,boundary_loops,euler_characteristic,e_max,e_avg,"
    "energy,sum_abs_defect,min_angle,roughness,flattenable,bending,mean_curvature,ruling_defect,"
    "self_intersections";
constexpr const char* k_no_patch = ",,,,,,,,,,,,,,,,";
constexpr const char* k_strain_columns =
    "strain_max,strain_rms,strain_p99,smallest_limit,limits_kept";
constexpr const char* k_no_strain = ",,,,";

std::string patch_cells(const std::optional<MeasuredPatch>& patch) {
  if (!patch) return k_no_patch;
  const Topology& topology = patch->inspection.topology;
  const Flattenability& figures = patch->figures;
  const SelfIntersections& crossings = patch->self_intersections;
  return joined({std::to_string(topology.vertices), std::to_string(topology.triangles),
                 std::to_string(topology.inner_vertices), std::to_string(topology.components),
                 std::to_string(topology.border_loops),
                 std::to_string(topology.euler_characteristic), csv_number(figures.e_max),
                 csv_number(figures.e_avg), csv_number(figures.energy),
                 csv_number(figures.sum_abs_defect), csv_number(figures.min_angle),
                 csv_number(figures.roughness), patch->flattenable ? "1" : "0",
                 csv_number(patch->bending.bending), csv_number(patch->bending.mean_curvature),
                 csv_number(patch->ruling_defect),
                 crossings.complete ? std::to_string(crossings.pairs) : std::string()});
}

std::string strain_cells(const std::optional<StrainAsDesigned>& strain) {
  if (!strain) return k_no_strain;
  const EdgeStrain& least = strain->least_stretch;
  const std::string kept = all_kept(strain->limits) ? "1" : "0";
  return joined({csv_number(least.max), csv_number(least.rms), csv_number(least.p99),
                 csv_number(strain->smallest_limit), strain->limits.empty() ? "" : kept});
}

Json to_json(const MeasuredFile& file) {
  Json json = {{"path", file.path}};
  if (file.patch) {
    json.update(to_json(*file.patch));
    json.update(strain_and_limits(file.strain));
  }
  json["error"] = file.failure ? to_json(*file.failure) : Json(nullptr);
  return json;
}

}  // namespace

std::string measured_csv(std::span<const MeasuredFile> files) {
  std::string csv =
      std::string("path,") + k_patch_columns + "," + k_strain_columns + ",error,message\n";
  for (const MeasuredFile& file : files) {
    const Failure failure = file.failure.value_or(Failure{});
    csv += csv_text(file.path) + ',' + patch_cells(file.patch) + ',' + strain_cells(file.strain) +
           ',' + failure.code + ',' + csv_text(failure.message) + '\n';
  }
  return csv;
}

std::string measured_json(std::span<const MeasuredFile> files, const std::string& csv) {
  Json list = Json::array();
  for (const MeasuredFile& file : files)
    list.push_back(to_json(file));
  return json_document({{"version", k_version},
                        {"files", std::move(list)},
                        {"csv", csv.empty() ? Json(nullptr) : Json(csv)}}) +
         '\n';
}

}  // namespace planish
