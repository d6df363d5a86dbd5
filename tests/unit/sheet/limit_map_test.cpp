#include "sheet/limit_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include <planish/draw/color.h>
#include <planish/draw/format_drawing.h>
#include <planish/mesh/patch.h>
#include <planish/sheet/pattern_sheet.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sheet/strain_map.h"
#include "support/sample_report.h"
#include "unfold/strain/vertex_strain.h"
#include "unit/sheet/layers.h"

namespace planish {
namespace {

using testing::Contains;

constexpr double k_infinity = std::numeric_limits<double>::infinity();

std::vector<Vec2> plane(const TriMesh& mesh) {
  std::vector<Vec2> positions;
  for (const Vec3 p : mesh.positions)
    positions.push_back({p.x, p.y});
  return positions;
}

/// Longer by 4 % along one line and shorter by 1 % across it, the line turned by an angle.
std::vector<Vec2> stretched(const TriMesh& mesh, double angle) {
  const Vec2 along = {std::cos(angle), std::sin(angle)}, across = {-along.y, along.x};
  std::vector<Vec2> positions = plane(mesh);
  for (Vec2& p : positions)
    p = 1.04 * dot(p, along) * along + 0.99 * dot(p, across) * across;
  return positions;
}

UnfoldReport with_limits(const TriMesh& mesh, std::vector<Vec2> pattern,
                         const StrainLimits& limits) {
  UnfoldReport unfold = samples::plane_below(mesh, 4.0, 2.0);
  unfold.pattern.positions = std::move(pattern);
  const Patch patch(mesh);
  unfold.strain = edge_strain(patch, unfold.pattern.positions);
  unfold.limits = check_limits(patch, unfold.pattern.positions, limits);
  return unfold;
}

double area_of(const std::vector<DrawingShape>& map, Color color) {
  double doubled = 0.0;
  for (const DrawingShape& shape : map) {
    const auto& path = std::get<Path>(shape);
    if (path.fill != color) continue;
    for (const auto& line : path.lines) {
      for (std::size_t i = 0; i < line.size(); ++i)
        doubled += cross(line[i], line[(i + 1) % line.size()]);
    }
  }
  return doubled / 2.0;
}

TEST(LimitOfEdges, IsTheSmallerOfThoseForEdges) {
  const auto check = [](Criterion kind, double asked) {
    LimitCheck some;
    some.what = kind;
    some.limit = asked;
    return some;
  };
  const LimitCheck max = check(Criterion::strain, 0.08), p99 = check(Criterion::p99_strain, 0.05),
                   rms = check(Criterion::rms_strain, 0.01);
  EXPECT_FALSE(limit_of_edges({}));
  EXPECT_FALSE(limit_of_edges(std::array{rms})) << "is for no single place";
  EXPECT_EQ(limit_of_edges(std::array{max, rms})->stretch, 0.08);
  EXPECT_EQ(limit_of_edges(std::array{max, p99, rms})->compression, 0.05);
  EXPECT_EQ(limit_of_edges(std::array{max, p99, rms})->words, limit_words(p99));
  EXPECT_EQ(limit_words(max), "8 %, for every edge");
  EXPECT_EQ(limit_words(p99), "5 %, on 99 % of the area");
}

TEST(LimitOfEdges, IsOfStretchAndOfCompressionApart) {
  LimitCheck all, stretch, compression;
  all.limit = 0.1;
  stretch.what = Criterion::p99_stretch;
  stretch.limit = 0.08;
  compression.what = Criterion::compression;
  compression.limit = 0.02;
  const auto apart = limit_of_edges(std::array{all, stretch, compression});
  EXPECT_EQ(apart->stretch, 0.08);
  EXPECT_EQ(apart->compression, 0.02);
  EXPECT_EQ(apart->weight_of_stretch(), 0.25);
  EXPECT_EQ(apart->words,
            "8 % of stretch, on 99 % of the area, and 2 % of compression, for every edge");
  EXPECT_EQ(limit_band(-0.06, *apart), 7) << "three quarters of the limit of stretch";
  EXPECT_EQ(limit_band(0.06, *apart), 10);
  const auto one = limit_of_edges(std::array{stretch});
  EXPECT_EQ(limit_band(0.5, *one), 0) << "no limit of compression";
  EXPECT_GT(one->weight_of_stretch(), 1000.0);
  EXPECT_EQ(limit_of_edges(std::array{compression})->weight_of_stretch(), 0.0);
  EXPECT_EQ(limit_of_edges(std::array{all, stretch})->words,
            "8 % of stretch, on 99 % of the area, and 10 %, for every edge");
}

TEST(LimitBand, IsTheLastExactlyBeyondTheLimit) {
  const MapLimit both = {0.05, 0.05, {}};
  const double limit = 0.05;
  EXPECT_EQ(limit_band(0.0, both), 0);
  EXPECT_EQ(limit_band(0.0049, both), 0);
  EXPECT_EQ(limit_band(-0.0051, both), 1);
  EXPECT_EQ(limit_band(0.0451, both), 9);
  EXPECT_EQ(limit_band(limit, both), 9);
  EXPECT_EQ(limit_band(-limit, both), 9);
  EXPECT_EQ(limit_band(std::nextafter(limit, 1.0), both), 10);
  EXPECT_EQ(limit_band(-k_infinity, both), 10);
  EXPECT_EQ(limit_band(std::numeric_limits<double>::quiet_NaN(), both), 0);
}

TEST(VertexStretches, AreThoseThatThePatchWasStretchedBy) {
  const TriMesh mesh = meshes::flat_grid(5, 4);
  for (const double angle : {0.0, 0.7, 2.0}) {
    for (const PrincipalStretch& stretch : vertex_stretches(mesh, stretched(mesh, angle))) {
      EXPECT_NEAR(stretch.max, 1.04, 1e-12) << angle;
      EXPECT_NEAR(stretch.min, 0.99, 1e-12) << angle;
    }
  }
}

TEST(VertexStretches, AreNoneWithoutTriangles) {
  TriMesh mesh = meshes::flat_grid(1, 1);
  mesh.positions.push_back({9.0, 9.0, 0.0});
  const PrincipalStretch stretch = vertex_stretches(mesh, stretched(mesh, 0.0)).back();
  EXPECT_EQ(stretch.max, 1.0);
  EXPECT_EQ(stretch.min, 1.0);
}

TEST(LargestEdgeStrains, OfTrianglesHaveTheirEdgesAndNoMore) {
  const TriMesh mesh = meshes::flat_grid(5, 4);
  for (const double strain : largest_edge_strains_of_triangles(mesh, stretched(mesh, 0.0)))
    EXPECT_NEAR(strain, 0.04, 1e-12);
  // Aslant no edge lies along the longest line, so each is below the principal stretch.
  const std::vector<Vec2> pattern = stretched(mesh, 0.3);
  const double largest = edge_strain(Patch(mesh), pattern).max;
  EXPECT_LT(largest, 0.0399);
  const auto strains = largest_edge_strains_of_triangles(mesh, pattern);
  EXPECT_EQ(*std::max_element(strains.begin(), strains.end()), largest);
}

TEST(LargestEdgeStrains, AreThoseThatUseUpMostOfTheirLimit) {
  const TriMesh mesh = meshes::flat_grid(5, 4);
  // 4 % longer one way and 1 % shorter the other: with a limit of stretch of a tenth that counts.
  for (const double strain : largest_edge_strains_of_triangles(mesh, stretched(mesh, 0.0), 10.0))
    EXPECT_NEAR(strain, -0.01, 1e-12);
  for (const double strain : largest_edge_strains(Patch(mesh), stretched(mesh, 0.0), 10.0))
    EXPECT_NEAR(strain, -0.01, 1e-12);
}

TEST(LimitMap, PaintsWhatIsBeyondAndNothingThatKeepsTheLimit) {
  const TriMesh mesh = meshes::flat_grid(4, 2);
  std::vector<Vec2> pattern = plane(mesh);
  for (Vec2& p : pattern)
    p.x = p.x <= 3.0 ? p.x : 3.0 + 1.03 * (p.x - 3.0);
  const auto strains = largest_edge_strains_of_triangles(mesh, pattern);
  const auto map_for = [&](double limit) {
    const MapLimit both = {limit, limit, {}};
    return strain_map(
        mesh, pattern, strains, [&](double strain) { return limit_band(strain, both); },
        limit_band_color);
  };
  EXPECT_NEAR(area_of(map_for(0.02), k_beyond_limit), 2.06, 1e-12);
  EXPECT_NEAR(area_of(map_for(0.02), limit_band_color(0)), 8.06, 1e-12) << "the ground";
  EXPECT_EQ(area_of(map_for(0.0301), k_beyond_limit), 0.0);
  EXPECT_NEAR(area_of(map_for(0.0301), limit_band_color(9)), 2.06, 1e-12) << "99.7 % used up";
  EXPECT_NEAR(area_of(map_for(0.0601), limit_band_color(4)), 2.06, 1e-12) << "half used up";
}

TEST(LimitMap, IsOnTheSheetWithItsLegendWhereALimitWasAsked) {
  const TriMesh mesh = meshes::flat_grid(4, 2);
  const auto sheet_with = [&](const StrainLimits& limits) {
    return pattern_sheet(Patch(mesh), with_limits(mesh, stretched(mesh, 0.0), limits), "");
  };
  const auto texts_of = [](const Drawing& sheet) {
    std::vector<std::string> texts;
    for (const DrawingShape& shape : layer_of(sheet, "legend").shapes) {
      if (const auto* text = std::get_if<Text>(&shape)) texts.push_back(text->text);
    }
    return texts;
  };
  const Drawing missed = sheet_with({.max = 0.02}), kept = sheet_with({.p99 = 0.05});
  EXPECT_GT(area_of(missed.layers.front().shapes, k_beyond_limit), 0.0);
  EXPECT_EQ(area_of(kept.layers.front().shapes, k_beyond_limit), 0.0);
  EXPECT_THAT(texts_of(missed),
              Contains("limit of strain used up; the limit is 2 %, for every edge"));
  EXPECT_THAT(texts_of(missed), Contains("beyond"));
  EXPECT_THAT(texts_of(kept),
              Contains("limit of strain used up; the limit is 5 %, on 99 % of the area"));
  const auto map_of = [&](const StrainLimits& limits) {
    Drawing sheet = sheet_with(limits);
    for (Layer& some : sheet.layers) {
      if (some.name == "label") some.shapes.clear();
    }
    return format_svg(sheet);
  };
  EXPECT_EQ(map_of({.rms = 0.02}), map_of({}))
      << "a limit that is for no place leaves the map as it is";
}

using Matrix = std::array<std::array<double, 3>, 3>;

std::array<double, 3> product(const Matrix& m, const std::array<double, 3>& v) {
  std::array<double, 3> result = {};
  for (std::size_t i = 0; i < 3; ++i)
    result[i] = m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2];
  return result;
}

/// CIELAB of a colour as it is seen.
/// @param eyes what they make of linear RGB
std::array<double, 3> seen(Color color, const Matrix& eyes) {
  const auto linear = [](std::uint8_t part) {
    const double share = part / 255.0;
    return share <= 0.04045 ? share / 12.92 : std::pow((share + 0.055) / 1.055, 2.4);
  };
  auto light = product(eyes, {linear(color.r), linear(color.g), linear(color.b)});
  for (double& part : light)
    part = std::clamp(part, 0.0, 1.0);
  constexpr Matrix to_xyz = {
      {{0.4124, 0.3576, 0.1805}, {0.2126, 0.7152, 0.0722}, {0.0193, 0.1192, 0.9505}}};
  auto xyz = product(to_xyz, light);
  xyz[0] /= 0.9505;
  xyz[2] /= 1.089;
  for (double& part : xyz)
    part = part > 0.008856 ? std::cbrt(part) : 7.787 * part + 16.0 / 116.0;
  return {116.0 * xyz[1] - 16.0, 500.0 * (xyz[0] - xyz[1]), 200.0 * (xyz[1] - xyz[2])};
}

// Machado, Oliveira, Fernandes, A physiologically-based model for simulation of color vision
// deficiency, 2009, table 1, severity 1.
TEST(LimitMap, ShowsWhatIsBeyondToColourBlindEyes) {
  constexpr std::array<Matrix, 4> eyes = {{{{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}},
                                           {{{0.152286, 1.052583, -0.204868},
                                             {0.114503, 0.786281, 0.099216},
                                             {-0.003882, -0.048116, 1.051998}}},
                                           {{{0.367322, 0.860646, -0.227968},
                                             {0.280085, 0.672501, 0.047413},
                                             {-0.011820, 0.042940, 0.968881}}},
                                           {{{1.255528, -0.076749, -0.178779},
                                             {-0.078411, 0.930809, 0.147602},
                                             {0.004733, 0.691367, 0.303900}}}}};
  for (const Matrix& some : eyes) {
    const auto beyond = seen(k_beyond_limit, some);
    for (int i = 0; i <= 100; ++i) {
      const auto within = seen(color_at(ColorMap::pale, i / 100.0), some);
      const double apart =
          std::hypot(beyond[0] - within[0], beyond[1] - within[1], beyond[2] - within[2]);
      EXPECT_GT(apart, 55.0) << i << " %, with eyes of " << some[0][0];
    }
  }
}

}  // namespace
}  // namespace planish
