#include "report/pictures/direction_map.h"

#include <cstdlib>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "report/pictures/direction_picture.h"
#include "support/meshes.h"
#include "support/page.h"

namespace planish {
namespace {

using testing::HasSubstr;

TEST(DirectionCsv, HasALineAVertexAndNoNumbersOnTheBorder) {
  EXPECT_EQ(direction_csv(std::vector<VertexDirection>{{VertexClass::border, 0.0, 0.0, false},
                                                       {VertexClass::saddle, -0.25, 0.5, false},
                                                       {VertexClass::dome_or_cup, 0.1, -1e-7, true},
                                                       {VertexClass::flat, 0.0, 0.0, false},
                                                       {VertexClass::unused, 0.0, 0.0, false}}),
            "vertex,class,defect,laplacian_slope,can_lower\n"
            "0,border,,,\n1,saddle,-0.25,0.5,0\n2,dome_or_cup,0.1,-1e-07,1\n3,flat,0,0,0\n"
            "4,unused,,,\n");
}

std::size_t pixels_like(const Image& image, Color color) {
  std::size_t count = 0;
  for (const Color pixel : image.pixels) {
    // Alike but for the brightness.
    const double scale = static_cast<double>(pixel.r + pixel.g + pixel.b) /
                         static_cast<double>(color.r + color.g + color.b);
    const auto near = [&](int a, int b) { return std::abs(a - scale * b) < 6.0; };
    if (scale > 0.3 && near(pixel.r, color.r) && near(pixel.g, color.g) && near(pixel.b, color.b))
      ++count;
  }
  return count;
}

TEST(DirectionPictures, HaveTheColoursOfTheirKeysAndTheCounts) {
  const TriMesh mesh = meshes::rough_grid(20, 20, 5, 0.0, 0.05);
  const auto directions = laplacian_directions(Patch(mesh));
  const DirectionPictures pictures = direction_pictures(mesh, directions, 300);
  const DirectionCounts counts = count_directions(directions);
  ASSERT_EQ(counts.inner, 361U);
  ASSERT_GT(counts.can_lower, 20U);
  ASSERT_GT(counts.stuck, 20U);
  const auto text = [](std::size_t count) { return std::to_string(count); };
  EXPECT_EQ(pictures.classes.keys[0].text, "dome or cup, d > 0: " + text(counts.dome_or_cup));
  EXPECT_EQ(pictures.classes.keys[1].text, "saddle, d < 0: " + text(counts.saddle));
  EXPECT_EQ(pictures.directions.keys[0].text, "yes: " + text(counts.can_lower));
  EXPECT_EQ(pictures.directions.keys[1].text, "no: " + text(counts.stuck));
  // Every vertex has a cell of about the same size.
  const double yes = static_cast<double>(
      pixels_like(pictures.directions.image, pictures.directions.keys[0].color));
  const double no = static_cast<double>(
      pixels_like(pictures.directions.image, pictures.directions.keys[1].color));
  EXPECT_NEAR(yes / no, static_cast<double>(counts.can_lower) / static_cast<double>(counts.stuck),
              0.15 * yes / no);
}

TEST(DirectionSvg, IsOneFileWithTwoPicturesAndEscapedWords) {
  const TriMesh mesh = meshes::rough_grid(6, 6, 1);
  const auto directions = laplacian_directions(Patch(mesh));
  const std::string svg = direction_svg(mesh, directions, "<a&b>");
  EXPECT_THAT(svg, HasSubstr("<title>&lt;a&amp;b&gt;: where"));
  EXPECT_EQ(pages::count(svg, "href=\"data:image/png;base64,"), 2U);
  EXPECT_EQ(pages::count(svg, "<svg "), 1U);
  EXPECT_EQ(pages::count(svg, "<text "), pages::count(svg, "</text>"));
  EXPECT_THAT(svg, HasSubstr("saddle, d &lt; 0: "));
}

}  // namespace
}  // namespace planish
