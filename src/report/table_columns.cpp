// Tables of several files: their columns are figures of what --json prints.

#include <algorithm>
#include <cmath>

#include "core/number_text.h"
#include "report/several_files.h"

namespace planish {

namespace {

constexpr std::string_view k_measured =
    "vertices triangles inner_vertices components boundary_loops euler_characteristic e_max e_avg "
    "energy sum_abs_defect min_angle roughness flattenable bending mean_curvature ruling_defect "
    "self_intersections area border_length strain_max=strain/max strain_rms=strain/rms "
    "strain_p99=strain/p99 smallest_limit=strain/smallest_limit limits_kept=limits";

constexpr std::string_view k_evolved =
    "method sweeps stop seconds vertices=before/vertices triangles=before/triangles "
    "e_max_before=before/e_max e_max_after=after/e_max e_avg_before=before/e_avg "
    "e_avg_after=after/e_avg energy_before=before/energy energy_after=after/energy "
    "sum_abs_defect_before=before/sum_abs_defect sum_abs_defect_after=after/sum_abs_defect "
    "min_angle_before=before/min_angle min_angle_after=after/min_angle "
    "roughness_before=before/roughness roughness_after=after/roughness "
    "flattenable=after/flattenable deviation_rms=deviation/rms deviation_max=deviation/max "
    "deviation_rms_over_diagonal=deviation/rms_over_diagonal bending_ratio bending_added "
    "bending_lost smooth form_kept";

constexpr std::string_view k_unfolded =
    "strain_max=strain/max strain_rms=strain/rms strain_p99=strain/p99 border_strain width height "
    "unit area_ratio overlaps flipped_triangles iterations converged limits_kept=limits";

constexpr std::string_view k_flattened =
    "vertices=evolve/before/vertices triangles=evolve/before/triangles "
    "inner_vertices=evolve/before/inner_vertices boundary_loops=evolve/before/boundary_loops "
    "area=evolve/before/area e_max_before=evolve/before/e_max e_max_after=evolve/after/e_max "
    "method=evolve/method sweeps=evolve/sweeps stop=evolve/stop "
    "strain_max_before=unfold_before/strain/max strain_rms_before=unfold_before/strain/rms "
    "strain_max=unfold/strain/max strain_rms=unfold/strain/rms strain_p99=unfold/strain/p99 "
    "width=unfold/width height=unfold/height unit=unfold/unit area_ratio=unfold/area_ratio "
    "overlaps=unfold/overlaps flipped_triangles=unfold/flipped_triangles "
    "deviation_rms=evolve/deviation/rms deviation_max=evolve/deviation/max "
    "bending_ratio=evolve/bending_ratio form_kept=evolve/form_kept limits_kept=limits "
    "limits_met usable";

constexpr std::string_view k_strain_before =
    "strain_max_before=unfold_before/strain/max strain_rms_before=unfold_before/strain/rms "
    "strain_p99_before=unfold_before/strain/p99";

/// Of checks whether all are kept, null of none; all else as it is.
Json single_figure(const Json& figure) {
  if (!figure.is_array()) return figure;
  if (figure.empty()) return nullptr;
  return std::all_of(figure.begin(), figure.end(),
                     [](const Json& check) { return check["kept"].get<bool>(); });
}

/// Empty where nothing is known.
std::string cell_text(const Json& given) {
  const Json figure = single_figure(given);
  if (figure.is_string()) return figure.get<std::string>();
  if (figure.is_boolean()) return figure.get<bool>() ? "1" : "0";
  if (figure.is_number_integer()) return figure.dump();
  const bool is_known = figure.is_number_float() && std::isfinite(figure.get<double>());
  return is_known ? number_text(figure.get<double>()) : std::string();
}

}  // namespace

std::vector<Column> columns_of(std::string_view words, const std::string& folder) {
  std::vector<Column> columns;
  while (!words.empty()) {
    const std::string_view word = words.substr(0, words.find(' '));
    words.remove_prefix(std::min(words.size(), word.size() + 1));
    const std::size_t end = word.find('=');
    columns.push_back({std::string(word.substr(0, end)),
                       Json::json_pointer(folder + std::string(word.substr(end + 1)))});
  }
  return columns;
}

std::vector<Column> measured_columns() {
  return columns_of(k_measured);
}

std::vector<Column> evolved_columns() {
  return columns_of(k_evolved);
}

std::vector<Column> unfolded_columns() {
  return columns_of(k_unfolded);
}

std::vector<Column> compared_columns() {
  std::vector<Column> all = evolved_columns();
  for (const auto& more : {columns_of(k_strain_before), columns_of(k_unfolded, "/unfold/"),
                           columns_of("best verdict")})
    all.insert(all.end(), more.begin(), more.end());
  return all;
}

std::vector<Column> flattened_columns() {
  return columns_of(k_flattened);
}

Json figures_in(const std::vector<Column>& columns, const Json& figures) {
  Json found = Json::object();
  for (const Column& column : columns) {
    const bool is_known = figures.contains(column.path);
    found[column.name] = is_known ? single_figure(figures[column.path]) : Json(nullptr);
  }
  return found;
}

std::string cell_text(const Column& column, const Json& figures) {
  return figures.contains(column.path) ? cell_text(figures[column.path]) : std::string();
}

std::string csv_of(const std::vector<Column>& columns, const Json& lines) {
  std::string csv;
  for (const Column& column : columns)
    csv += (csv.empty() ? "" : ",") + column.name;
  csv += '\n';
  for (const Json& figures : lines) {
    for (const Column& column : columns)
      csv += (&column == &columns.front() ? "" : ",") + cell_text(column, figures);
    csv += '\n';
  }
  return csv;
}

}  // namespace planish
