#pragma once

// A report without evolving or unfolding: a bumpy patch, its pattern the plane over which it
// stands, and figures that are all different, so that a mistaken one shows.

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include <planish/flatten/flatten.h>

#include <nlohmann/json.hpp>

#include "support/meshes.h"

namespace planish::samples {

inline TriMesh bumpy_patch(std::size_t columns, std::size_t rows, double height) {
  return meshes::height_field(columns, rows, [&](double x, double y) {
    return height * std::sin(6.0 * x / static_cast<double>(columns)) *
           std::sin(4.0 * y / static_cast<double>(rows));
  });
}

/// The plane below a patch as its pattern.
inline UnfoldReport plane_below(const TriMesh& mesh, double width, double height) {
  UnfoldReport report;
  for (const Vec3 p : mesh.positions)
    report.pattern.positions.push_back({p.x, p.y});
  report.pattern.width = width;
  report.pattern.height = height;
  report.pattern.converged = true;
  report.pattern.iterations = 7;
  return report;
}

inline MeasuredPatch measured(double factor) {
  MeasuredPatch patch;
  patch.inspection.topology = {651, 1200, 549, 1850, 1, 1, 0, 1};
  patch.figures = {0.0641 * factor, 0.00312 * factor, 0.137 * factor,
                   1.713 * factor,  0.3011 * factor,  2.471 * factor};
  patch.bending = {41.7 * factor, 3.17 * factor};
  patch.ruling_defect = 0.203 * factor;
  return patch;
}

inline FlattenReport flatten_report() {
  FlattenReport report;
  report.name = "front panel";
  report.input = Patch(bumpy_patch(30, 20, 2.0));
  report.processed = Patch(bumpy_patch(30, 20, 1.5));
  report.evolve.method = ControllableLaplacian{};
  report.evolve.before = measured(1.0);
  report.evolve.after = measured(0.73);
  report.evolve.deviation = {0.1234, 0.5678, 0.00345};
  report.evolve.fairness = {.bending_ratio = 1.13,
                            .bending_added = 0.31,
                            .bending_lost = 0.17,
                            .sharp_share = 0.0125,
                            .normal_turn = 3.4,
                            .border_turn = 5.6,
                            .sharpest_fold = Fold{40, 41, 9.5, {9.5, 1.0, 0.25}},
                            .form_change = FormChange{.ripple = 0.4,
                                                      .fold = 0.7,
                                                      .fold_at = {9.5, 1.0, 0.25},
                                                      .dent = 0.01,
                                                      .dent_at = {4.5, 3.0, 0.5},
                                                      .uneven_turn = 1.5,
                                                      .relief_lost = 0.125,
                                                      .edge_lost = 0.0625}};
  report.evolve.result.positions = report.processed.positions();
  report.evolve.result.threads = 2;
  report.evolve.result.seconds = 0.25;
  const Flattenability& figures = report.evolve.before.figures;
  for (int sweep = 1; sweep <= 10; ++sweep) {
    const double factor = 1.0 - 0.027 * sweep;
    report.evolve.result.history.push_back({sweep, figures.e_max * factor, figures.e_avg * factor,
                                            figures.energy * factor, 549, 0.025 * sweep});
  }
  report.unfold = plane_below(report.processed.mesh(), 30.0, 20.0);
  report.unfold.strain = {0.3187, 0.0761, 0.2143, {}, 0.3187, 0.2143, 0.25, 0.1875};
  report.unfold.pattern.area_ratio = 1.0021;
  report.design_least_stretch = plane_below(report.input.mesh(), 30.5, 20.5);
  report.design_least_stretch.strain = {0.3241, 0.0763, 0.2213, {}, 0.3241, 0.2213, 0.25, 0.1875};
  report.design_least_stretch.pattern.area_ratio = 1.0034;
  report.design_pattern = report.design_least_stretch;
  return report;
}

/// A document as it stands in a larger one: without the number of the format, and without what is
/// missed and what the mesh cannot show, which the larger one says of the whole.
inline nlohmann::ordered_json part_of(const std::string& document) {
  auto json = nlohmann::ordered_json::parse(document);
  for (const char* key : {"schema", "limits_met", "usable", "missed", "cautions"})
    json.erase(key);
  return json;
}

}  // namespace planish::samples
