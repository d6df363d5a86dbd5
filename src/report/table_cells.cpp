// The figures of the verbs as cells of a table; one list for names and texts of the columns.

#include <cmath>
#include <iterator>

#include "core/number_text.h"
#include "report/several_files.h"

namespace planish {

namespace {

std::string cell_text(bool value) {
  return value ? "1" : "0";
}
std::string cell_text(double value) {
  return std::isfinite(value) ? number_text(value) : std::string();
}
std::string cell_text(std::size_t value) {
  return std::to_string(value);
}
std::string cell_text(int value) {
  return std::to_string(value);
}
std::string cell_text(std::string_view value) {
  return std::string(value);
}
std::string cell_text(const std::optional<double>& value) {
  return value ? cell_text(*value) : std::string();
}
std::string cell_text(const std::optional<bool>& value) {
  return value ? cell_text(*value) : std::string();
}

/// Cells of figures that may all be missing, as their columns' names stay then.
template <class Report>
class CellsOf {
 public:
  explicit CellsOf(const Report* report) : report_(report) {}

  template <class Figure>
  CellsOf& add(std::string_view name, Figure&& figure) {
    cells_.push_back({name, report_ ? cell_text(figure(*report_)) : std::string()});
    return *this;
  }
  std::vector<Cell> take() { return std::move(cells_); }

 private:
  const Report* report_;
  std::vector<Cell> cells_;
};

std::vector<Cell> operator+(std::vector<Cell> cells, const std::vector<Cell>& more) {
  cells.insert(cells.end(), more.begin(), more.end());
  return cells;
}

std::vector<Cell> cells_of(const MeasuredPatch* patch) {
  return CellsOf(patch)
      .add("vertices", [](auto& p) { return p.inspection.topology.vertices; })
      .add("triangles", [](auto& p) { return p.inspection.topology.triangles; })
      .add("inner_vertices", [](auto& p) { return p.inspection.topology.inner_vertices; })
      .add("components", [](auto& p) { return p.inspection.topology.components; })
      .add("boundary_loops", [](auto& p) { return p.inspection.topology.border_loops; })
      .add("euler_characteristic",
           [](auto& p) { return std::to_string(p.inspection.topology.euler_characteristic); })
      .add("e_max", [](auto& p) { return p.figures.e_max; })
      .add("e_avg", [](auto& p) { return p.figures.e_avg; })
      .add("energy", [](auto& p) { return p.figures.energy; })
      .add("sum_abs_defect", [](auto& p) { return p.figures.sum_abs_defect; })
      .add("min_angle", [](auto& p) { return p.figures.min_angle; })
      .add("roughness", [](auto& p) { return p.figures.roughness; })
      .add("flattenable", [](auto& p) { return p.flattenable; })
      .add("bending", [](auto& p) { return p.bending.bending; })
      .add("mean_curvature", [](auto& p) { return p.bending.mean_curvature; })
      .add("ruling_defect", [](auto& p) { return p.ruling_defect; })
      .add("self_intersections",
           [](auto& p) {
             const SelfIntersections& found = p.self_intersections;
             return found.complete ? std::to_string(found.pairs) : std::string();
           })
      .add("area", [](auto& p) { return p.size.area; })
      .add("border_length", [](auto& p) { return p.size.border_length; })
      .take();
}

std::optional<bool> kept(const std::vector<StrainLimitCheck>& limits) {
  if (limits.empty()) return std::nullopt;
  return all_kept(limits);
}

std::vector<Cell> cells_of(const StrainAsDesigned* strain) {
  return CellsOf(strain)
      .add("strain_max", [](auto& s) { return s.least_stretch.max; })
      .add("strain_rms", [](auto& s) { return s.least_stretch.rms; })
      .add("strain_p99", [](auto& s) { return s.least_stretch.p99; })
      .add("smallest_limit", [](auto& s) { return s.smallest_limit; })
      .add("limits_kept", [](auto& s) { return kept(s.limits); })
      .take();
}

}  // namespace

std::vector<Cell> measured_cells(const MeasuredPatch* patch, const StrainAsDesigned* strain) {
  return cells_of(patch) + cells_of(strain);
}

std::vector<Cell> evolved_cells(const EvolveReport* report) {
  return CellsOf(report)
      .add("method", [](auto& r) { return r.method_name(); })
      .add("sweeps", [](auto& r) { return r.result.history.size(); })
      .add("stop", [](auto& r) { return to_string(r.result.stop); })
      .add("seconds", [](auto& r) { return r.result.seconds; })
      .add("vertices", [](auto& r) { return r.before.inspection.topology.vertices; })
      .add("triangles", [](auto& r) { return r.before.inspection.topology.triangles; })
      .add("e_max_before", [](auto& r) { return r.before.figures.e_max; })
      .add("e_max_after", [](auto& r) { return r.after.figures.e_max; })
      .add("e_avg_before", [](auto& r) { return r.before.figures.e_avg; })
      .add("e_avg_after", [](auto& r) { return r.after.figures.e_avg; })
      .add("energy_before", [](auto& r) { return r.before.figures.energy; })
      .add("energy_after", [](auto& r) { return r.after.figures.energy; })
      .add("sum_abs_defect_before", [](auto& r) { return r.before.figures.sum_abs_defect; })
      .add("sum_abs_defect_after", [](auto& r) { return r.after.figures.sum_abs_defect; })
      .add("min_angle_before", [](auto& r) { return r.before.figures.min_angle; })
      .add("min_angle_after", [](auto& r) { return r.after.figures.min_angle; })
      .add("roughness_before", [](auto& r) { return r.before.figures.roughness; })
      .add("roughness_after", [](auto& r) { return r.after.figures.roughness; })
      .add("flattenable", [](auto& r) { return r.after.flattenable; })
      .add("deviation_rms", [](auto& r) { return r.deviation.rms; })
      .add("deviation_max", [](auto& r) { return r.deviation.max; })
      .add("deviation_rms_over_diagonal", [](auto& r) { return r.deviation.rms_over_diagonal; })
      .add("bending_ratio", [](auto& r) { return r.fairness.bending_ratio; })
      .add("bending_added", [](auto& r) { return r.fairness.bending_added; })
      .add("bending_lost", [](auto& r) { return r.fairness.bending_lost; })
      .add("smooth", [](auto& r) { return r.fairness.is_smooth(); })
      .add("form_kept", [](auto& r) { return r.fairness.keeps_form(); })
      .take();
}

std::vector<Cell> unfolded_cells(const UnfoldReport* report) {
  return CellsOf(report)
      .add("strain_max", [](auto& r) { return r.strain.max; })
      .add("strain_rms", [](auto& r) { return r.strain.rms; })
      .add("strain_p99", [](auto& r) { return r.strain.p99; })
      .add("border_strain", [](auto& r) { return r.border_strain; })
      .add("width", [](auto& r) { return r.pattern.width; })
      .add("height", [](auto& r) { return r.pattern.height; })
      .add("unit", [](auto& r) { return to_string(r.unit); })
      .add("area_ratio", [](auto& r) { return r.pattern.area_ratio; })
      .add("overlaps", [](auto& r) { return r.pattern.overlaps; })
      .add("flipped_triangles", [](auto& r) { return r.pattern.flipped_triangles; })
      .add("iterations", [](auto& r) { return r.pattern.iterations; })
      .add("converged", [](auto& r) { return r.pattern.converged; })
      .add("limits_kept", [](auto& r) { return kept(r.limits); })
      .take();
}

std::vector<Cell> compared_cells(const CompareReport* report, const ComparedMethod* run) {
  // A run that failed has a method too.
  std::vector<Cell> cells = evolved_cells(run && run->evolve ? &*run->evolve : nullptr);
  if (run) cells.front().text = name_of(run->run.method);
  const UnfoldReport* before = report && report->unfold_before ? &*report->unfold_before : nullptr;
  cells = std::move(cells) + CellsOf(before)
                                 .add("strain_max_before", [](auto& r) { return r.strain.max; })
                                 .add("strain_rms_before", [](auto& r) { return r.strain.rms; })
                                 .add("strain_p99_before", [](auto& r) { return r.strain.p99; })
                                 .take();
  cells = std::move(cells) + unfolded_cells(run && run->unfold ? &*run->unfold : nullptr);
  const auto is_best = [&](const ComparedMethod& some) {
    if (report == nullptr) return false;
    const auto best = best_run(*report);
    return best && &report->runs[*best] == &some;
  };
  return std::move(cells) +
         CellsOf(run)
             .add("best", is_best)
             .add("verdict",
                  [&](auto& some) { return report ? verdict_text(*report, some) : std::string(); })
             .take();
}

}  // namespace planish
