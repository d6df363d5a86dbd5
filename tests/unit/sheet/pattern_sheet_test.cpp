#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include <planish/draw/color.h>
#include <planish/draw/format_drawing.h>
#include <planish/sheet/pattern_sheet.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sheet/strain_map.h"
#include "support/sample_report.h"
#include "unit/sheet/layers.h"

namespace planish {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsSupersetOf;
using testing::Not;

struct PathBox {
  double left = 1e300, bottom = 1e300, right = -1e300, top = -1e300;
};

PathBox box_of(const Path& path) {
  PathBox box;
  for (const auto& line : path.lines) {
    for (const Vec2 p : line) {
      box = {std::min(box.left, p.x), std::min(box.bottom, p.y), std::max(box.right, p.x),
             std::max(box.top, p.y)};
    }
  }
  return box;
}

const Path& cut_path(const Drawing& drawing) {
  return std::get<Path>(layer_of(drawing, "cut").shapes.at(0));
}

std::vector<std::string> texts_of(const Layer& some) {
  std::vector<std::string> texts;
  for (const DrawingShape& shape : some.shapes) {
    if (const auto* text = std::get_if<Text>(&shape)) texts.push_back(text->text);
  }
  return texts;
}

double area(const Path& path) {
  double doubled = 0.0;  // holes run the other way around
  for (const auto& line : path.lines) {
    for (std::size_t i = 0; i < line.size(); ++i) {
      doubled += cross(line[i] - line[0], line[(i + 1) % line.size()] - line[0]);
    }
  }
  return doubled / 2.0;
}

Drawing sheet_of(double size_in_mm, const std::string& name = "panel") {
  const TriMesh mesh = meshes::flat_grid(4, 4);
  UnfoldReport unfold = samples::plane_below(mesh, size_in_mm, size_in_mm);
  for (Vec2& p : unfold.pattern.positions)
    p = size_in_mm / 4.0 * p;
  return pattern_sheet(Patch(mesh), unfold, name);
}

TEST(PatternSheet, HasTheCutLineOverAllElse) {
  const Drawing sheet = sheet_of(300.0);
  ASSERT_EQ(sheet.layers.size(), k_sheet_layers.size());
  EXPECT_EQ(sheet.title, "panel");
  for (std::size_t i = 0; i < k_sheet_layers.size(); ++i)
    EXPECT_EQ(sheet.layers[i].name, k_sheet_layers[i]);
}

TEST(PatternSheet, IsTrueToScaleInEveryUnit) {
  const TriMesh mesh = meshes::flat_grid(4, 3);
  for (const Unit unit : {Unit::mm, Unit::cm, Unit::m, Unit::in}) {
    UnfoldReport unfold = samples::plane_below(mesh, 4.0, 3.0);
    unfold.unit = unit;
    const PathBox box = box_of(cut_path(pattern_sheet(Patch(mesh), unfold, "")));
    EXPECT_NEAR(box.right - box.left, 4.0 * millimetres_per(unit), 1e-9);
    EXPECT_NEAR(box.top - box.bottom, 3.0 * millimetres_per(unit), 1e-9);
  }
}

TEST(PatternSheet, CutsAlongTheBorderOnceAndClosed) {
  const Drawing sheet = sheet_of(100.0);
  const Path& cut = cut_path(sheet);
  ASSERT_EQ(cut.lines.size(), 1U);
  EXPECT_TRUE(cut.closed);
  EXPECT_EQ(cut.lines[0].size(), 16U) << "border vertices of 4 x 4 cells";
  EXPECT_NEAR(area(cut), 100.0 * 100.0, 1e-6);
  EXPECT_FALSE(cut.fill);
  ASSERT_TRUE(cut.stroke);
  EXPECT_EQ(cut.stroke->color, (Color{255, 0, 0}));
  EXPECT_EQ(cut.stroke->width, 0.25);
}

TEST(PatternSheet, HasATestSquareOfExactly50MillimetresClearOfThePattern) {
  for (const double size : {1.0, 40.0, 200.0, 3000.0}) {
    const Drawing sheet = sheet_of(size);
    const PathBox square = box_of(std::get<Path>(layer_of(sheet, "label").shapes.at(0)));
    EXPECT_EQ(square.right - square.left, 50.0);
    EXPECT_EQ(square.top - square.bottom, 50.0);
    EXPECT_LT(square.top, box_of(cut_path(sheet)).bottom - 1.0);
    EXPECT_THAT(texts_of(layer_of(sheet, "label")), Contains("50 mm – measure before cutting"));
  }
}

TEST(PatternSheet, HoldsEverythingWithAMargin) {
  for (const double size : {1.0, 400.0}) {
    const Drawing sheet = sheet_of(size);
    for (const Layer& some : sheet.layers) {
      for (const DrawingShape& shape : some.shapes) {
        const auto* path = std::get_if<Path>(&shape);
        if (path == nullptr) continue;
        const PathBox box = box_of(*path);
        EXPECT_GE(std::min(box.left, box.bottom), 10.0 - 1e-9);
        EXPECT_LE(box.right, sheet.width - 10.0 + 1e-9);
        EXPECT_LE(box.top, sheet.height - 10.0 + 1e-9);
      }
    }
  }
}

TEST(PatternSheet, StatesNameSizeUnitAndTheEndsOfTheColours) {
  const TriMesh mesh = meshes::flat_grid(4, 3);
  UnfoldReport unfold = samples::plane_below(mesh, 4.0, 3.0);
  unfold.unit = Unit::in;
  unfold.strain.p99 = 0.031;
  const Drawing sheet = pattern_sheet(Patch(mesh), unfold, "collar");
  const auto texts = texts_of(layer_of(sheet, "label")),
             legend = texts_of(layer_of(sheet, "legend"));
  EXPECT_THAT(texts, Contains("collar"));
  EXPECT_THAT(texts, Contains("101.6 × 76.2 mm"));
  EXPECT_THAT(texts, Contains("model unit: in (1 in = 25.4 mm)"));
  EXPECT_THAT(legend, Contains("−5 %"));
  EXPECT_THAT(legend, Contains("+5 %"));
  const Drawing plain = without_map(sheet);
  EXPECT_EQ(plain.layers.size(), sheet.layers.size());
  EXPECT_TRUE(layer_of(plain, "strain").shapes.empty());
  EXPECT_TRUE(layer_of(plain, "legend").shapes.empty());
  EXPECT_EQ(texts_of(layer_of(plain, "label")), texts);
}

TEST(PatternSheet, WarnsOfAPatternThatIsNotToBeCut) {
  const TriMesh mesh = meshes::flat_grid(4, 3);
  UnfoldReport unfold = samples::plane_below(mesh, 4.0, 3.0);
  unfold.pattern.overlaps = true;
  EXPECT_THAT(texts_of(layer_of(pattern_sheet(Patch(mesh), unfold, ""), "label")),
              Contains(HasSubstr("overlaps itself")));
  unfold.pattern.overlaps = false;
  unfold.pattern.flipped_triangles = 2;
  EXPECT_THAT(texts_of(layer_of(pattern_sheet(Patch(mesh), unfold, ""), "label")),
              Contains(HasSubstr("flipped")));
}

TEST(PatternSheet, SaysWhereTheAllowanceFillsASlit) {
  TriMesh mesh = meshes::flat_grid(40, 40);
  std::erase_if(mesh.triangles, [&](const Triangle& t) {  // a slit 1 wide and 30 deep
    const Vec3 middle =
        (1.0 / 3.0) * (mesh.positions[t[0]] + mesh.positions[t[1]] + mesh.positions[t[2]]);
    return middle.x > 20.0 && middle.x < 21.0 && middle.y < 30.0;
  });
  const UnfoldReport unfold = samples::plane_below(mesh, 40.0, 40.0);
  const auto label = [&](double width) {
    const PatternOptions options = {.allowance = Allowance{.width = width}};
    return texts_of(layer_of(pattern_sheet(Patch(mesh), unfold, "", options), "label"));
  };
  // Both sides, 30 each, and the tip.
  const std::string words = "61 mm of seam line in slits or darts that the allowance fills";
  EXPECT_THAT(label(10.0), Contains(words));
  EXPECT_THAT(label(0.4), Not(Contains(HasSubstr("fills"))));
}

TEST(PatternSheet, SaysWhatStrainThePatternHasAndWhetherItKeepsItsLimit) {
  const TriMesh mesh = meshes::flat_grid(4, 3);
  UnfoldReport unfold = samples::plane_below(mesh, 4.0, 3.0);
  unfold.strain.rms = 0.00512;
  unfold.strain.max = 0.0231;
  const auto label = [&] {
    return texts_of(layer_of(pattern_sheet(Patch(mesh), unfold, ""), "label"));
  };
  EXPECT_THAT(label(), Contains("strain rms 0.51 % · largest 2.31 %"));
  PatternOptions options;
  options.model_scale = 0.5;
  options.moved = 0.0042;
  unfold.unit = Unit::m;
  const Drawing changed = pattern_sheet(Patch(mesh), unfold, "", options);
  EXPECT_THAT(texts_of(layer_of(changed, "label")),
              IsSupersetOf({"strain rms 0.51 % · largest 2.31 % · moved up to 4.2 mm",
                            "model unit: m (1 m = 1000 mm), model multiplied by 0.5"}));
  unfold.unit = Unit::mm;
  EXPECT_THAT(label(), Not(Contains(HasSubstr("limit"))));
  options.form_faults = "is lost";
  const auto label_of_form = [&] {
    return texts_of(layer_of(pattern_sheet(Patch(mesh), unfold, "", options), "label"));
  };
  EXPECT_THAT(label_of_form(), Contains("Before cutting: the form is lost"));
  PatternOptions with_cautions;
  with_cautions.cautions = "no vertex inside, coarse facets";
  const auto label_of_mesh = [&] {
    return texts_of(layer_of(pattern_sheet(Patch(mesh), unfold, "", with_cautions), "label"));
  };
  EXPECT_THAT(label_of_mesh(),
              Contains("Before cutting, see the mesh: no vertex inside, coarse facets"));
  unfold.limits = {{Criterion::strain, 0.025, 0.0231}};
  EXPECT_THAT(label(), Contains("keeps the limit 2.5 %, for every edge"));
  EXPECT_THAT(label_of_form(),
              Contains("keeps the limit 2.5 %, for every edge, but the form is lost"));
  EXPECT_THAT(label_of_mesh(),
              Contains("keeps the limit 2.5 %, for every edge, but see the mesh: no vertex"));
  EXPECT_THAT(label_of_mesh(), Contains("inside, coarse facets"));
  unfold.limits.push_back({Criterion::rms_strain, 0.005, 0.00512});
  EXPECT_THAT(label(), Contains("Beyond the limit 0.5 %, rms: 0.51 %"));
  EXPECT_THAT(pattern_sheet(Patch(mesh), unfold, "").notes,
              Contains("Beyond the limit 0.5 %, rms: 0.51 %"));
}

TEST(PatternSheet, ShortensANameThatIsTooLongBetweenItsLetters) {
  std::string name;
  for (int i = 0; i < 200; ++i)
    name += "ü";
  const Layer label = layer_of(sheet_of(100.0, name), "label");
  const auto texts = texts_of(label);
  const auto found = std::find_if(texts.begin(), texts.end(),
                                  [](const std::string& text) { return text.starts_with("ü"); });
  ASSERT_NE(found, texts.end());
  EXPECT_LT(found->size(), 120U);
  EXPECT_TRUE(found->ends_with("ü…"));
}

TEST(StrainMapLimit, IsTheNext125AndAtLeastAThousandth) {
  EXPECT_EQ(strain_map_limit({0.5, 0.1, 0.031}), 0.05);
  EXPECT_EQ(strain_map_limit({0.5, 0.1, 0.02}), 0.02);
  EXPECT_EQ(strain_map_limit({1e-9, 1e-9, 1e-9}), 0.001);
  EXPECT_EQ(strain_map_limit({}), 0.001);
  EXPECT_EQ(strain_map_limit({1, 1, std::numeric_limits<double>::quiet_NaN()}), 0.001);
}

TEST(StrainBand, HasAMiddleThatReachesEvenlyToBothSides) {
  const double limit = 0.021;  // bands of 0.002
  EXPECT_EQ(strain_band(0.0, limit), 0);
  EXPECT_EQ(strain_band(0.00099, limit), 0);
  EXPECT_EQ(strain_band(-0.00099, limit), 0);
  EXPECT_EQ(strain_band(0.00101, limit), 1);
  EXPECT_EQ(strain_band(-0.00101, limit), -1);
  EXPECT_EQ(strain_band(0.0201, limit), 10);
  EXPECT_EQ(strain_band(9.0, limit), 10);
  EXPECT_EQ(strain_band(-std::numeric_limits<double>::infinity(), limit), -10);
  EXPECT_EQ(strain_band(std::numeric_limits<double>::quiet_NaN(), limit), 0);
}

// The paths of a strain map by colour.
const Path* path_of_band(const std::vector<DrawingShape>& map, int band) {
  for (const DrawingShape& shape : map) {
    const auto& path = std::get<Path>(shape);
    if (path.fill == band_color(band)) return &path;
  }
  return nullptr;
}

TEST(StrainMap, OfACheckerPaintsTheStrainedCellsOverTheWhole) {
  const TriMesh mesh = meshes::flat_grid(3, 3);
  std::vector<Vec2> corners;
  for (const Vec3 p : mesh.positions)
    corners.push_back({p.x, p.y});
  std::vector<double> strains;
  for (std::size_t t = 0; t < 18; ++t)
    strains.push_back((t / 2) % 2 == 0 ? 0.01 * 1.1 / 10.5 : 0);
  const auto map = strain_map(
      mesh, corners, strains, [](double strain) { return strain_band(strain, 0.01); }, band_color);
  ASSERT_EQ(map.size(), 2U);
  ASSERT_NE(path_of_band(map, 0), nullptr);
  EXPECT_EQ(area(*path_of_band(map, 0)), 9.0);
  ASSERT_NE(path_of_band(map, 1), nullptr);
  EXPECT_EQ(path_of_band(map, 1)->lines.size(), 5U);
  EXPECT_EQ(area(*path_of_band(map, 1)), 5.0);
}

TEST(StrainMap, ShowsEveryTriangleInItsBandsColour) {
  const TriMesh mesh = meshes::rough_grid(40, 30, 11, 0.3, 0.0);
  std::vector<Vec2> corners;
  for (const Vec3 p : mesh.positions)
    corners.push_back({p.x, p.y});
  std::vector<double> strains;
  std::vector<double> expected(2 * k_bands_a_side + 1, 0.0);
  const auto triangle_area = [&](std::size_t t) {
    const auto [a, b, c] = mesh.triangles[t];
    return cross(corners[b] - corners[a], corners[c] - corners[a]) / 2.0;
  };
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    strains.push_back(0.013 * std::sin(0.37 * static_cast<double>(t)) *
                      std::cos(0.011 * static_cast<double>(t)));
    expected[k_bands_a_side + strain_band(strains.back(), 0.01)] += triangle_area(t);
  }
  const auto map = strain_map(
      mesh, corners, strains, [](double strain) { return strain_band(strain, 0.01); }, band_color);
  // A path covers its band and those beyond, which are painted over it.
  const auto painted = [&](int band) {
    const Path* path = path_of_band(map, band);
    return path == nullptr ? 0.0 : area(*path);
  };
  double shown = 0.0;
  for (int band = -k_bands_a_side; band <= k_bands_a_side; ++band) {
    double visible = painted(band);
    if (band == 0) visible -= painted(1) + painted(-1);
    if (band > 0 && band < k_bands_a_side) visible -= painted(band + 1);
    if (band < 0 && band > -k_bands_a_side) visible -= painted(band - 1);
    EXPECT_NEAR(visible, expected[k_bands_a_side + band], 1e-9) << band;
    shown += visible;
  }
  EXPECT_NEAR(shown, 1200.0, 60.0) << "the border is rough";
  for (const DrawingShape& shape : map) {
    EXPECT_TRUE(std::get<Path>(shape).closed);
    for (const auto& line : std::get<Path>(shape).lines)
      EXPECT_GE(line.size(), 3U);
  }
}

TEST(StrainMap, StaysSmallOnADenseMesh) {
  const std::size_t columns = 440;  // 387,200 triangles
  const TriMesh mesh = samples::bumpy_patch(columns, columns, 8.0);
  UnfoldReport unfold = samples::plane_below(mesh, 440.0, 440.0);
  unfold.strain = {0.02, 0.004, 0.01};
  const std::string svg = format_svg(pattern_sheet(Patch(mesh), unfold, "dense"));
  EXPECT_LT(svg.size(), 2'000'000U);
  EXPECT_GT(svg.size(), 50'000U) << "there is a map at all";
}

}  // namespace
}  // namespace planish
