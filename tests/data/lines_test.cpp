// Lines on whole products.

#include <algorithm>
#include <optional>
#include <vector>

#include <planish/mesh/imprint.h>
#include <planish/mesh/surface_line.h>

#include <gtest/gtest.h>

#include "lines/line_checks.h"
#include "lines/random_lines.h"
#include "mesh/mean_edge.h"
#include "support/test_files.h"

namespace planish {
namespace {

/// @param most_jag of each line, where the product has no narrow bend along it
void expect_fair(const Patch& patch, const std::vector<SurfaceLine>& lines,
                 std::optional<double> most_jag) {
  ASSERT_FALSE(lines.empty());
  const ImprintedMesh imprinted = imprint(patch, lines);
  lines::Figures figures;
  EXPECT_EQ(lines::wrong_imprint(patch, lines, imprinted, figures), "");
  EXPECT_LE(static_cast<double>(figures.thin - figures.given),
            0.01 * static_cast<double>(figures.triangles));
  const double edge = mean_edge_length(patch.mesh());
  std::size_t long_lines = 0;
  for (std::size_t l = 0; l < lines.size(); ++l) {
    std::vector<Vec3> seam;
    for (const Index v : imprinted.paths[l])
      seam.push_back(imprinted.mesh.positions[v]);
    const double drawn = length_of(lines[l], patch.positions());
    if (drawn < 40.0 * edge) continue;
    ++long_lines;
    EXPECT_NEAR(lines::length_of(seam), drawn, 0.002 * drawn) << "line " << l;
    std::vector<Vec3> given;
    for (const SurfacePoint& point : lines[l])
      given.push_back(position_of(point, patch.positions()));
    // Bends of the product make some longer than their chords.
    EXPECT_LE(jag_of(seam, edge), jag_of(given, edge) + 2e-4) << "line " << l;
    if (most_jag) {
      EXPECT_LE(jag_of(seam, edge), *most_jag) << "line " << l;
    }
  }
  EXPECT_GT(long_lines, 0U);
}

struct Section {
  const char* product;
  int axis;
  double share;  // of the way through the product
  std::optional<double> most_jag = {};
};

class LinesOnProducts : public WithProducts<testing::TestWithParam<Section>> {};

TEST_P(LinesOnProducts, AreFair) {
  const Section& section = GetParam();
  const Patch patch = product(section.product);
  const Vec3 normal = section.axis == 0   ? Vec3{1.0, 0.0, 0.0}
                      : section.axis == 1 ? Vec3{0.0, 1.0, 0.0}
                                          : Vec3{0.0, 0.0, 1.0};
  double low = dot(normal, patch.positions()[0]), high = low;
  for (const Vec3 p : patch.positions()) {
    low = std::min(low, dot(normal, p));
    high = std::max(high, dot(normal, p));
  }
  const double at = low + section.share * (high - low);
  expect_fair(patch, plane_section(patch, {normal, at}), section.most_jag);
}

constexpr double k_fair = 1.005;

INSTANTIATE_TEST_SUITE_P(RoundTheHat, LinesOnProducts,
                         testing::Values(Section{"hat", 1, 0.2, k_fair},
                                         Section{"hat", 1, 0.5, k_fair}, Section{"hat", 0, 0.5},
                                         Section{"hat", 2, 0.5}));
INSTANTIATE_TEST_SUITE_P(RoundTheShoe, LinesOnProducts,
                         testing::Values(Section{"shoe", 1, 0.2, k_fair},
                                         Section{"shoe", 0, 0.5, k_fair}, Section{"shoe", 1, 0.5},
                                         Section{"shoe", 2, 0.5}));
INSTANTIATE_TEST_SUITE_P(RoundTheHull, LinesOnProducts,
                         testing::Values(Section{"hull", 1, 0.2, k_fair},
                                         Section{"hull", 1, 0.5, k_fair}, Section{"hull", 0, 0.45},
                                         Section{"hull", 2, 0.5}));

class LinesOnTheHull : public WithProducts<> {};

TEST_F(LinesOnTheHull, AreFairAlongChines) {
  const Patch patch = product("hull");
  expect_fair(patch, crease_lines(patch, 30.0), std::nullopt);
}

class LinesOnTheDress : public WithFolder<testing::Test> {
 protected:
  LinesOnTheDress() : WithFolder<testing::Test>("patches") {}
};

// Stars and spirals around a long triangle: widening an angle there once put a point onto the end
// of a line.
TEST_F(LinesOnTheDress, GiveNoEdgesWithoutALength) {
  const Patch patch(read_mesh(test_folder() / "patches" / "dress_front_5k.obj").mesh);
  lines::Drawer drawer(patch, 786);
  const std::vector<SurfaceLine> drawn = drawer.lines(lines::Kind::crossing, 10);
  lines::Figures figures;
  EXPECT_EQ(lines::wrong_imprint(patch, drawn, imprint(patch, drawn), figures), "");
}

}  // namespace
}  // namespace planish
