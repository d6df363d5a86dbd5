#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "draw/image.h"

namespace planish {
namespace {

constexpr Color k_black = {0, 0, 0}, k_white = {255, 255, 255}, k_red = {255, 0, 0},
                k_blue = {0, 0, 255};
constexpr double k_nan = std::numeric_limits<double>::quiet_NaN();
constexpr double k_infinity = std::numeric_limits<double>::infinity();

// A surface that owns what it is made of.
struct Scene {
  std::vector<Vec3> vertices;
  std::vector<std::array<Index, 3>> triangles;
  std::vector<Color> colors;
  std::vector<double> brightness;

  void add(Vec3 a, Vec3 b, Vec3 c, Color color, double light = 1.0) {
    const auto first = static_cast<Index>(vertices.size());
    vertices.insert(vertices.end(), {a, b, c});
    triangles.push_back({first, first + 1, first + 2});
    colors.insert(colors.end(), 3, color);
    brightness.insert(brightness.end(), 3, light);
  }
  ShadedSurface surface() const { return {vertices, triangles, colors, brightness}; }
};

Color pixel(const Image& image, int x, int y) {
  return image.pixels[static_cast<std::size_t>(y) * image.width + x];
}

TEST(Render, CoversTheSamplesWhoseCentresTheTriangleHolds) {
  Scene scene;
  scene.add({0, 0, 0}, {8, 0, 0}, {0, 8, 0}, k_red);
  const Image image = render(scene.surface(), 10, 10, k_white);
  ASSERT_EQ(image.pixels.size(), 100U);
  for (int y = 0; y < 10; ++y) {
    for (int x = 0; x < 10; ++x) {
      // Of the four samples on the diagonal x + y = 7 one lies beyond the edge, two on it.
      const Color expected = x + y < 7 ? k_red : x + y == 7 ? Color{255, 64, 64} : k_white;
      EXPECT_EQ(pixel(image, x, y), expected) << x << ',' << y;
    }
  }
}

TEST(Render, ShowsTheNearerWhateverComesFirst) {
  for (const bool near_first : {true, false}) {
    Scene scene;
    const double z = near_first ? 5.0 : -5.0;
    scene.add({-9, -9, z}, {30, -9, z}, {-9, 30, z}, near_first ? k_red : k_blue);
    scene.add({-9, -9, 0}, {30, -9, 0}, {-9, 30, 0}, near_first ? k_blue : k_red);
    EXPECT_EQ(pixel(render(scene.surface(), 4, 4, k_white), 1, 2), k_red);
  }
}

TEST(Render, CutsTrianglesThatPierceEachOther) {
  Scene scene;
  scene.add({-50, -50, 0}, {100, -50, 0}, {0, 100, 0}, k_blue);
  scene.add({-50, -50, -55}, {100, -50, 95}, {0, 100, -5}, k_red);  // z = x - 5
  const Image image = render(scene.surface(), 10, 10, k_white);
  EXPECT_EQ(pixel(image, 3, 5), k_blue);
  EXPECT_EQ(pixel(image, 6, 5), k_red);
}

TEST(Render, BlendsColoursAndDimsThemByBrightness) {
  Scene scene;
  scene.add({0, 0, 0}, {100, 0, 0}, {0, 100, 0}, k_black);
  scene.colors = {{0, 0, 0}, {200, 0, 0}, {0, 200, 0}};
  scene.brightness = {1.0, 0.5, 1.0};
  const Image image = render(scene.surface(), 100, 100, k_white);
  // At (25.5, 40.5) the shares are 0.34, 0.255 and 0.405.
  const double light = 0.34 + 0.255 * 0.5 + 0.405;
  EXPECT_NEAR(pixel(image, 25, 40).r, 200 * 0.255 * light, 1.5);
  EXPECT_NEAR(pixel(image, 25, 40).g, 200 * 0.405 * light, 1.5);
  EXPECT_EQ(pixel(image, 25, 40).b, 0);
}

TEST(Render, LeavesNoGapBetweenNeighbours) {
  // A fan of needles about an odd place: every sample inside is covered by one of them.
  Scene scene;
  constexpr int spokes = 97;
  scene.vertices.push_back({31.4159, 27.1828, 0.0});
  for (int i = 0; i < spokes; ++i) {
    const double angle = 2.0 * 3.141592653589793 * i / spokes;
    scene.vertices.push_back({31.4159 + 500 * std::cos(angle), 27.1828 + 500 * std::sin(angle), 0});
    scene.triangles.push_back(
        {0, static_cast<Index>(i + 1), static_cast<Index>((i + 1) % spokes + 1)});
  }
  scene.colors.assign(scene.vertices.size(), k_red);
  scene.brightness.assign(scene.vertices.size(), 1.0);
  for (const Color color : render(scene.surface(), 64, 64, k_white).pixels) {
    ASSERT_EQ(color, k_red);
  }
}

TEST(Render, IsClearWhereNothingIsAndThereIsNoBackground) {
  Scene scene;
  scene.add({0, 0, 0}, {8, 0, 0}, {0, 8, 0}, k_red);
  const Image image = render(scene.surface(), 10, 10);
  ASSERT_EQ(image.alpha.size(), 100U);
  EXPECT_EQ(image.alpha[0], 255);
  EXPECT_EQ(image.alpha[7], 191) << "three of four samples";
  EXPECT_EQ(pixel(image, 7, 0), k_red) << "the colour of a rim is not mixed with any other";
  EXPECT_EQ(image.alpha[99], 0);
}

TEST(Render, PassesOverWhatHasNoAreaOrIsNoNumberOrLiesOutside) {
  Scene scene;
  scene.add({1, 1, 0}, {5, 5, 0}, {9, 9, 0}, k_red);  // on a line
  scene.add({4, 4, 0}, {4, 4, 0}, {4, 4, 0}, k_red);  // a point
  scene.add({k_nan, 0, 0}, {9, 0, 0}, {0, 9, 0}, k_red);
  scene.add({0, 0, k_nan}, {9, 0, 0}, {0, 9, 0}, k_red);
  scene.add({-k_infinity, 0, 0}, {9, 0, 0}, {0, 9, 0}, k_red);
  scene.add({1e308, -1e308, 0}, {9, 0, 0}, {-1e308, 1e308, 0}, k_red);  // overflows
  scene.add({-20, -20, 0}, {-5, -20, 0}, {-20, -5, 0}, k_red);
  scene.add({20, 20, 0}, {35, 20, 0}, {20, 35, 0}, k_red);
  for (const Color color : render(scene.surface(), 10, 10, k_white).pixels) {
    ASSERT_EQ(color, k_white);
  }
}

TEST(Render, DrawsTrianglesFarLargerThanTheImage) {
  Scene scene;
  scene.add({-1e12, -1e12, 0}, {2e12, -1e12, 0}, {0, 2e12, 0}, k_blue);
  for (const Color color : render(scene.surface(), 10, 10, k_white).pixels) {
    ASSERT_EQ(color, k_blue);
  }
}

}  // namespace
}  // namespace planish
