#include <cmath>
#include <numbers>
#include <set>
#include <string>
#include <vector>

#include <planish/draw/format_drawing.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "unit/draw/dxf/read_dxf.h"

namespace planish {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const DxfOptions k_r2000 = {.version = DxfVersion::r2000};

/// A line, an arc and two cubics that meet with one tangent.
Drawing with_curve() {
  Path path{{{{0, 0}, {10, 0}, {20, 10}, {0, 10}}}, true, Stroke{{255, 0, 0}}};
  const double half = 10.0 * std::numbers::sqrt2 / 2.0;
  path.fitted.curves = {
      Curve{{0, 0},
            {LineTo{{10, 0}}, ArcTo{{10 + half, 10 - half}, {20, 10}},
             CubicTo{{15, 14}, {12, 12}, {10, 11}}, CubicTo{{8, 10}, {4, 10}, {0, 0}}}}};
  path.fitted.few = path.lines;
  return {"sheet", 50.0, 40.0, {Layer{"cut", {path}}, Layer{"label", {Text{{1, 2}, 3.0, "é"}}}}};
}

std::vector<double> reals(const DxfEntity& entity, int code) {
  std::vector<double> found;
  for (const DxfTag& tag : entity) {
    if (tag.code == code) found.push_back(std::stod(tag.value));
  }
  return found;
}

TEST(DxfR2000, WritesArcsAsBulgesAndCubicsAsOneSpline) {
  const std::string dxf = format_dxf(with_curve(), k_r2000);
  EXPECT_THAT(dxf, HasSubstr("$ACADVER\n1\nAC1015\n"));
  const auto lines = all_of_kind(dxf, "LWPOLYLINE");
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_THAT(reals(lines[0], 10), ElementsAre(0.0, 10.0, 20.0));
  ASSERT_EQ(reals(lines[0], 42).size(), 1U) << "of the arc only";
  EXPECT_NEAR(reals(lines[0], 42)[0], std::tan(std::numbers::pi / 8.0), 1e-12) << "a quarter";
  const auto splines = all_of_kind(dxf, "SPLINE");
  ASSERT_EQ(splines.size(), 1U);
  EXPECT_THAT(reals(splines[0], 10), ElementsAre(20.0, 15.0, 12.0, 10.0, 8.0, 4.0, 0.0));
  EXPECT_THAT(reals(splines[0], 40), ElementsAre(0, 0, 0, 0, 1, 1, 1, 2, 2, 2, 2));
  EXPECT_EQ(value_of(splines[0], 72), "11");
  EXPECT_EQ(value_of(splines[0], 73), "7");
}

TEST(DxfR2000, EndsASplineAtACorner) {
  Drawing drawing = with_curve();
  auto& curve = std::get<Path>(drawing.layers[0].shapes[0]).fitted.curves[0];
  std::get<CubicTo>(curve.pieces[3]).first = {10, 4};
  EXPECT_EQ(all_of_kind(format_dxf(drawing, k_r2000), "SPLINE").size(), 2U);
}

TEST(DxfR2000, ClosesOutlinesOfLinesAndArcs) {
  Drawing drawing = with_curve();
  auto& path = std::get<Path>(drawing.layers[0].shapes[0]);
  path.fitted.curves[0].pieces.resize(2);
  path.fitted.curves[0].pieces.emplace_back(LineTo{{0, 0}});
  const auto lines = all_of_kind(format_dxf(drawing, k_r2000), "LWPOLYLINE");
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(value_of(lines[0], 70), "1");
  EXPECT_EQ(value_of(lines[0], 90), "3");
  path.fitted = {};
  const auto plain = all_of_kind(format_dxf(drawing, k_r2000), "LWPOLYLINE");
  EXPECT_EQ(value_of(plain.at(0), 90), "4") << "without curves the line itself";
}

TEST(DxfR2000, HasHandlesThatAreUniqueAndOwnersThatAreThere) {
  const std::string dxf = format_dxf(with_curve(), k_r2000);
  std::set<std::string> handles = {"0"};
  std::vector<std::string> owners;
  std::string seed;
  for (const DxfEntity& entity : read_dxf(dxf)) {
    for (std::size_t i = 0; i < entity.size(); ++i) {
      const DxfTag& tag = entity[i];
      if (i > 0 && entity[i - 1].value == "$HANDSEED") {
        seed = tag.value;
      } else if (tag.code == 5) {
        EXPECT_TRUE(handles.insert(tag.value).second) << tag.value;
      }
      if (tag.code == 330 || tag.code == 350) owners.push_back(tag.value);
    }
  }
  for (const std::string& owner : owners)
    EXPECT_EQ(handles.count(owner), 1U) << owner;
  for (const std::string& handle : handles)
    EXPECT_LT(std::stoul(handle, nullptr, 16), std::stoul(seed, nullptr, 16));
}

TEST(DxfR2000, HasTheTablesThatReadersExpect) {
  const std::string dxf = format_dxf(with_curve(), k_r2000);
  EXPECT_THAT(values(all_of_kind(dxf, "TABLE"), 2),
              ElementsAre("VPORT", "LTYPE", "LAYER", "STYLE", "VIEW", "UCS", "APPID", "DIMSTYLE",
                          "BLOCK_RECORD"));
  EXPECT_THAT(values(all_of_kind(dxf, "LAYER"), 2), ElementsAre("0", "cut", "label"));
  EXPECT_THAT(values(all_of_kind(dxf, "BLOCK"), 2), ElementsAre("*Model_Space", "*Paper_Space"));
  EXPECT_THAT(values(all_of_kind(dxf, "TEXT"), 1), ElementsAre("\\U+00E9"));
  EXPECT_TRUE(dxf.ends_with("0\nENDSEC\n0\nEOF\n"));
}

TEST(DxfVersions, AreKnownByTheirNames) {
  EXPECT_EQ(to_string(DxfVersion::r12), "r12");
  EXPECT_EQ(to_string(DxfVersion::r2000), "r2000");
}

}  // namespace
}  // namespace planish
