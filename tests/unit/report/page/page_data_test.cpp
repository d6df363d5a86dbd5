#include "report/page/page_data.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <planish/measure/fairness.h>
#include <planish/measure/flattenability.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "support/page.h"
#include "support/sample_report.h"
#include "support/unpack.h"

namespace planish {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

json content_of(const std::string& block) {
  const std::string open = "<script type=\"application/json\" id=\"report-data\">";
  EXPECT_EQ(block.find(open), 0U);
  return json::parse(block.substr(open.size(), block.rfind("</script>") - open.size()));
}

PageInput input_of(const FlattenReport& report) {
  PageInput input{{{"before", report.input, report.design_least_stretch.pattern.positions},
                   {"after", report.processed, report.unfold.pattern.positions}}};
  input.defect_limit = 0.05;
  return input;
}

TEST(PageData, HasThePatchToHalfAStep) {
  const FlattenReport report = samples::flatten_report();
  const json data = content_of(page_data(input_of(report)));
  EXPECT_EQ(data["vertices"], 651U);
  EXPECT_EQ(data["of"], 651U);
  const json& states = data["states"];
  const auto places = pages::small_numbers_of(states["positions"][1]);
  ASSERT_EQ(places.size(), 3U * 651U);
  for (std::size_t v = 0; v < 651; ++v) {
    const double step = states["step"][2],
                 z = states["low"][2].get<double>() + step * places[3 * v + 2];
    EXPECT_NEAR(z, report.processed.positions()[v].z, 0.5001 * step) << v;
  }
  const auto corners = pages::small_numbers_of(data["triangles"]["data"]);
  ASSERT_EQ(corners.size(), 3U * 1200U);
  EXPECT_EQ(corners[4], report.input.triangles()[1][1]);
}

TEST(PageData, HasScalesForPatchesOfAnySize) {
  const FlattenReport report = samples::flatten_report();
  for (const double size : {1e-180, 1e180}) {
    std::vector<Vec3> positions = report.input.positions();
    for (Vec3& p : positions)
      p = size * p;
    const Patch patch = report.input.with_positions(positions);
    PageInput input{{{"before", patch}, {"after", patch}}};
    input.defect_limit = 0.05;
    const json data = content_of(page_data(input));
    for (const json& figure : data["figures"]) {
      ASSERT_TRUE(figure["limit"].is_number()) << figure["id"] << " at " << size;
      EXPECT_GT(figure["limit"].get<double>(), 0.0) << figure["id"] << " at " << size;
    }
  }
}

TEST(PageData, HasTheStrainThatLimitsAreFor) {
  const FlattenReport report = samples::flatten_report();
  const json data = content_of(page_data(input_of(report)));
  ASSERT_EQ(data["figures"][5]["id"], "edge_strain");
  const std::array states = {std::pair(&report.input, &report.design_least_stretch),
                             std::pair(&report.processed, &report.unfold)};
  for (std::size_t state = 0; state < states.size(); ++state) {
    const auto [patch, unfold] = states[state];
    const EdgeStrain strain = edge_strain(*patch, unfold->pattern.positions);
    const auto shown = pages::floats_of(data["figures"][5]["values"][state]);
    double largest = 0.0;
    for (const float value : shown)
      largest = std::max(largest, std::abs(static_cast<double>(value)));
    EXPECT_NEAR(largest, strain.max, 1e-7 * strain.max);
    for (const Index end : strain.worst_edge)
      EXPECT_NEAR(std::abs(shown[end]), strain.max, 1e-7 * strain.max);
  }
}

TEST(PageData, HasPrincipalStretchesAndTheLimitWhereOneWasAsked) {
  const TriMesh mesh = meshes::flat_grid(5, 4);
  std::vector<Vec2> pattern;
  for (const Vec3 p : mesh.positions)
    pattern.push_back({-0.97 * p.y, 1.02 * p.x});
  const Patch patch(mesh);
  PageInput input{{{"before", patch, pattern}, {"after", patch}}};
  input.defect_limit = 0.05;
  EXPECT_FALSE(content_of(page_data(input)).contains("limit"));
  EXPECT_EQ(content_of(page_data(input))["figures"].size(), 7U);
  input.limit = {0.04, 0.01, {}};
  const json apart = content_of(page_data(input));
  EXPECT_EQ(apart["limit"]["stretch"], 0.04);
  EXPECT_EQ(apart["limit"]["compression"], 0.01);
  EXPECT_FALSE(apart["limit"].contains("asked"));
  for (const float value : pages::floats_of(apart["figures"][5]["values"][0]))
    EXPECT_NEAR(value, 0.02, 1e-8) << "twice its limit, where 3 % of 4 are less";
  input.limit = {0.025, 0.025, {}};
  const json data = content_of(page_data(input));
  EXPECT_EQ(data["limit"]["asked"], 0.025);
  EXPECT_EQ(data["limit"]["beyond"], json::array({240, 82, 10}));
  ASSERT_EQ(data["figures"].size(), 9U);
  EXPECT_EQ(data["figures"][6]["id"], "longest");
  EXPECT_EQ(data["figures"][7]["id"], "shortest");
  for (std::size_t i = 0; i < 2; ++i) {
    const json& values = data["figures"][6 + i]["values"];
    for (const float value : pages::floats_of(values[0]))
      EXPECT_NEAR(value, i == 0 ? 0.02 : -0.03, 1e-8);
    EXPECT_TRUE(values[1].is_null()) << "there is no pattern";
  }
}

TEST(PageData, HasTheFiguresOfEveryVertex) {
  const FlattenReport report = samples::flatten_report();
  const json data = content_of(page_data(input_of(report)));
  const Patch& patch = report.input;
  const auto defects = angle_defects(report.processed);
  const auto shown = pages::floats_of(data["figures"][0]["values"][1]);
  const auto moved = pages::floats_of(data["figures"][3]["values"][1]);
  ASSERT_EQ(shown.size(), defects.size());
  for (Index v = 0; v < defects.size(); ++v) {
    if (patch.is_border(v)) {
      EXPECT_TRUE(std::isnan(shown[v])) << v;
    } else {
      EXPECT_NEAR(shown[v], defects[v], 1e-7 * std::abs(defects[v])) << v;
    }
    EXPECT_NEAR(moved[v],
                std::abs(report.processed.positions()[v].z - report.input.positions()[v].z), 1e-6);
  }
  const auto bends = vertex_bends(report.processed);
  const auto bent = pages::floats_of(data["figures"][2]["values"][1]);
  for (Index v = 0; v < bends.size(); ++v)
    EXPECT_NEAR(bent[v], bends[v], 1e-7 * bends[v]) << v;
  EXPECT_EQ(data["figures"][0]["limit"], 0.05);
  EXPECT_EQ(data["figures"][1]["id"], "curvature");
  EXPECT_EQ(data["figures"][2]["id"], "bent");
  EXPECT_EQ(data["figures"][4]["id"], "strain");
}

TEST(PageData, HasOffsetsAlongTheNormalsOnAScaleThatFits) {
  const Patch patch(meshes::flat_grid(5, 4));
  std::vector<Vec3> after = patch.positions();
  for (Vec3& p : after)
    p = {p.x + 0.3, p.y, -0.1 * p.x};
  after[0].z = 0.137;
  PageInput input{{{"before", patch}, {"after", patch.with_positions(after)}}};
  input.defect_limit = 0.05;
  const json data = content_of(page_data(input));
  const json& offset = data["figures"].back();
  ASSERT_EQ(offset["id"], "offset");
  const auto shown = pages::floats_of(offset["values"][1]);
  for (std::size_t v = 0; v < shown.size(); ++v)
    EXPECT_NEAR(shown[v], after[v].z, 1e-7) << "the move along the surface does not count";
  EXPECT_TRUE(offset["values"][0].is_null()) << "the design has none";
  const double limit = offset["limit"];
  EXPECT_GE(limit, 0.5);
  EXPECT_LE(limit, 0.51) << "the largest offset";
}

TEST(PageData, DrawsLargeMeshesWithFewerVerticesTheWorstAmongThem) {
  const Patch before(samples::bumpy_patch(60, 50, 2.0));
  std::vector<Vec3> moved_positions = before.positions();
  moved_positions[61 * 20 + 13].z += 3.0;
  PageInput input{{{"before", before}, {"after", before.with_positions(moved_positions)}}};
  input.most_vertices = 500;
  const json data = content_of(page_data(input));
  EXPECT_EQ(data["of"], 61U * 51U);
  EXPECT_LE(data["vertices"], 700U);
  EXPECT_GE(data["vertices"], 300U);
  const auto numbers = pages::numbers_of(data["numbers"]);
  const auto worst = std::find(numbers.begin(), numbers.end(), 61U * 20U + 13U);
  ASSERT_NE(worst, numbers.end());
  const auto moved = pages::floats_of(data["figures"][3]["values"][1]);
  EXPECT_NEAR(moved[static_cast<std::size_t>(worst - numbers.begin())], 3.0, 1e-6)
      << "figures are those of the full mesh";
  EXPECT_TRUE(data["figures"][4]["values"][0].is_null()) << "no pattern, no strain";
}

TEST(PageData, NumbersVerticesAsPeopleKnowThem) {
  const FlattenReport report = samples::flatten_report();
  PageInput input = input_of(report);
  std::vector<Index> source(651);
  for (Index v = 0; v < 651; ++v)
    source[v] = 7 * v + 3;
  input.source = source;
  EXPECT_EQ(pages::numbers_of(content_of(page_data(input))["numbers"])[5], 38U);
}

TEST(PageData, CannotBeLeftByItsText) {
  const FlattenReport report = samples::flatten_report();
  PageInput input = input_of(report);
  input.states[1].name = "</script><script>alert(1)</script><!--\xFF";
  const std::string block = page_data(input);
  EXPECT_EQ(pages::count(block, "<script"), 1U);
  EXPECT_EQ(pages::count(block, "</script"), 1U);
  EXPECT_THAT(block, Not(HasSubstr("<!--")));
  EXPECT_EQ(content_of(block)["states"]["names"][1],
            "</script><script>alert(1)</script><!--\uFFFD");
  EXPECT_EQ(json_for_script("[\"<\"]"), "[\"\\u003c\"]");
}

TEST(PageData, StaysSmall) {
  const Patch patch(samples::bumpy_patch(220, 220, 5.0));
  const PageInput input{{{"before", patch}, {"after", patch}}};
  EXPECT_LT(page_data(input).size(), 5'000'000U) << "48 841 vertices, each drawn";
}

}  // namespace
}  // namespace planish
