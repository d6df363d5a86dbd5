// Lines on whole products, of the folder that PLANISH_TEST_DATA tells.

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <planish/io/read_mesh.h>
#include <planish/mesh/imprint.h>
#include <planish/mesh/surface_line.h>

#include <gtest/gtest.h>

#include "lines/line_checks.h"
#include "mesh/mean_edge.h"

namespace planish {
namespace {

std::filesystem::path product_file(const std::string& name) {
  const char* folder = std::getenv("PLANISH_TEST_DATA");
  if (folder == nullptr) return {};
  const auto file = std::filesystem::path(folder) / "products" / (name + ".obj");
  return std::filesystem::exists(file) ? file : std::filesystem::path();
}

void expect_fair(const Patch& patch, const std::vector<SurfaceLine>& lines, double most_jag) {
  ASSERT_FALSE(lines.empty());
  const ImprintedMesh imprinted = imprint(patch, lines);
  lines::Figures figures;
  EXPECT_EQ(lines::wrong_imprint(patch, lines, imprinted, figures), "");
  EXPECT_LE(static_cast<double>(figures.thin - figures.given),
            0.01 * static_cast<double>(figures.triangles));
  const double edge = mean_edge_length(patch.mesh());
  for (std::size_t l = 0; l < lines.size(); ++l) {
    std::vector<Vec3> seam;
    for (const Index v : imprinted.paths[l])
      seam.push_back(imprinted.mesh.positions[v]);
    const double drawn = length_of(lines[l], patch.positions());
    if (drawn < 40.0 * edge) continue;
    EXPECT_NEAR(lines::length_of(seam), drawn, 0.002 * drawn) << "line " << l;
    std::vector<Vec3> given;
    for (const SurfacePoint& point : lines[l])
      given.push_back(position_of(point, patch.positions()));
    // Bends of the product make some longer than their chords.
    EXPECT_LE(jag_of(seam, edge), jag_of(given, edge) + 2e-4) << "line " << l;
    EXPECT_LE(jag_of(seam, edge), most_jag) << "line " << l;
  }
}

struct Section {
  const char* product;
  int axis;
  double share;     // of the way through the product
  double most_jag;  // 1.005 where the product has no narrow bend along it
};

class LinesOnProducts : public testing::TestWithParam<Section> {};

TEST_P(LinesOnProducts, AreFair) {
  const Section& section = GetParam();
  const auto file = product_file(section.product);
  if (file.empty()) GTEST_SKIP() << "PLANISH_TEST_DATA names no folder with products";
  const Patch patch(read_mesh(file).mesh);
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

constexpr double k_fair = 1.005, k_bent = 2.0;

INSTANTIATE_TEST_SUITE_P(RoundTheHat, LinesOnProducts,
                         testing::Values(Section{"hat", 1, 0.2, k_fair},
                                         Section{"hat", 1, 0.5, k_fair},
                                         Section{"hat", 0, 0.5, k_bent},
                                         Section{"hat", 2, 0.5, k_bent}));
INSTANTIATE_TEST_SUITE_P(RoundTheShoe, LinesOnProducts,
                         testing::Values(Section{"shoe", 1, 0.2, k_fair},
                                         Section{"shoe", 0, 0.5, k_fair},
                                         Section{"shoe", 1, 0.5, k_bent},
                                         Section{"shoe", 2, 0.5, k_bent}));
INSTANTIATE_TEST_SUITE_P(RoundTheHull, LinesOnProducts,
                         testing::Values(Section{"hull", 1, 0.2, k_fair},
                                         Section{"hull", 1, 0.5, k_fair},
                                         Section{"hull", 0, 0.45, k_bent},
                                         Section{"hull", 2, 0.5, k_bent}));

TEST(LinesOnTheHull, AreFairAlongChines) {
  const auto file = product_file("hull");
  if (file.empty()) GTEST_SKIP() << "PLANISH_TEST_DATA names no folder with products";
  const Patch patch(read_mesh(file).mesh);
  expect_fair(patch, crease_lines(patch, 30.0), k_bent);
}

}  // namespace
}  // namespace planish
