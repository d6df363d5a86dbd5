#include <algorithm>
#include <cmath>
#include <map>

#include <planish/mesh/shapes.h>
#include <planish/report/json_report.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/meshes.h"
#include "support/sample_report.h"

namespace planish {
namespace {

std::map<std::string, std::vector<double>> by_name(const std::vector<MeshField>& fields) {
  std::map<std::string, std::vector<double>> named;
  for (const MeshField& field : fields)
    EXPECT_TRUE(named.emplace(field.name, field.values).second) << field.name;
  return named;
}

double largest_size(const std::vector<double>& values) {
  double largest = 0.0;
  for (const double value : values)
    largest = std::max(largest, std::abs(value));
  return largest;
}

FlattenReport flattened() {
  return flatten(Patch(make_shape("panel", 400)), "panel",
                 {.method = ControllableLaplacian{}, .stopping = Stopping{.max_sweeps = 5}});
}

TEST(FieldsOf, AFlatteningHaveTheFiguresOfItsReport) {
  const FlattenReport report = flattened();
  const MeshFields fields = fields_of(report);
  const auto vertices = by_name(fields.vertices), triangles = by_name(fields.triangles);
  EXPECT_EQ(largest_size(vertices.at("defect")), report.evolve.after.figures.e_max);
  EXPECT_EQ(largest_size(vertices.at("input_defect")), report.evolve.before.figures.e_max);
  EXPECT_EQ(largest_size(vertices.at("edge_strain")), report.unfold.strain.max);
  EXPECT_EQ(largest_size(vertices.at("input_edge_strain")), report.design_least_stretch.strain.max);
  EXPECT_NEAR(largest_size(vertices.at("move")), report.evolve.deviation.max, 1e-15);
  double squares = 0.0, inner = 0.0;
  for (std::size_t v = 0; v < vertices.at("move").size(); ++v) {
    const double move = vertices.at("move")[v];
    squares += move * move;
    inner += vertices.at("inner")[v];
    EXPECT_LE(std::abs(vertices.at("offset")[v]), move * (1.0 + 1e-12));
  }
  EXPECT_EQ(inner, static_cast<double>(report.evolve.before.inspection.topology.inner_vertices));
  EXPECT_NEAR(std::sqrt(squares / inner), report.evolve.deviation.rms, 1e-14);
  // The strain of an edge lies between the principal strains of each of its triangles.
  EXPECT_LE(report.unfold.strain.max, std::max(largest_size(triangles.at("strain_max")),
                                               largest_size(triangles.at("strain_min"))) +
                                          1e-14);
  for (std::size_t t = 0; t < triangles.at("strain_max").size(); ++t) {
    EXPECT_LE(triangles.at("strain_min")[t], triangles.at("strain_max")[t]);
    EXPECT_LE(triangles.at("input_strain_min")[t], triangles.at("input_strain_max")[t]);
  }
}

TEST(FieldsOf, OffsetsHaveTheSideOfTheDesignThatTheVertexWentTo) {
  FlattenReport report = samples::flatten_report();
  report.input = Patch(meshes::flat_grid(4, 4));
  std::vector<Vec3> raised = report.input.positions();
  for (std::size_t v = 0; v < raised.size(); ++v)
    raised[v] += Vec3{0.3, 0.0, v % 2 == 0 ? 0.4 : -0.4};
  report.processed = report.input.with_positions(raised);
  report.unfold = samples::plane_below(report.processed.mesh(), 4, 4);
  report.design_least_stretch = samples::plane_below(report.input.mesh(), 4, 4);
  const auto vertices = by_name(fields_of(report).vertices);
  for (std::size_t v = 0; v < raised.size(); ++v) {
    EXPECT_NEAR(vertices.at("offset")[v], v % 2 == 0 ? 0.4 : -0.4, 1e-15);
    EXPECT_NEAR(vertices.at("move")[v], 0.5, 1e-15);
  }
}

TEST(FieldsOf, APatchWithoutAPatternLackStrain) {
  const MeshFields fields = fields_of(Patch(meshes::torus(9, 8)));
  EXPECT_TRUE(fields.triangles.empty());
  const auto vertices = by_name(fields.vertices);
  EXPECT_EQ(vertices.size(), 3U);
  EXPECT_EQ(vertices.at("inner"), std::vector<double>(72, 1.0));
}

TEST(FieldsOf, AKnownPatternHaveItsStrain) {
  const Patch patch(meshes::flat_grid(3, 3));
  std::vector<Vec2> pattern;
  for (const Vec3 p : patch.positions())
    pattern.push_back({1.25 * p.x, 0.5 * p.y});
  const auto triangles = by_name(fields_of(patch, pattern).triangles);
  for (std::size_t t = 0; t < patch.triangles().size(); ++t) {
    EXPECT_NEAR(triangles.at("strain_max")[t], 0.25, 1e-15);
    EXPECT_NEAR(triangles.at("strain_min")[t], -0.5, 1e-15);
  }
}

}  // namespace
}  // namespace planish
