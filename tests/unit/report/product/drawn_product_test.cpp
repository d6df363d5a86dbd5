#include "report/product/drawn_product.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>

#include <planish/mesh/shapes.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/figure_text.h"
#include "report/product/whole_product.h"
#include "support/products.h"
#include "support/unpack.h"

namespace planish {
namespace {

using nlohmann::json;
using testing::HasSubstr;

constexpr std::size_t k_all = 100'000;

std::vector<ProductPatch> strips_of(std::size_t vertices) {
  std::vector<ProductPatch> patches;
  for (NamedPatch& strip : in_strips(make_shape("saddle", vertices), 3))
    patches.push_back({strip.name, std::move(strip.mesh)});
  return patches;
}

/// Three strips of which each moved, with two seams.
const ProductReport& strips_report() {
  static const ProductReport report = [] {
    ProductOptions options;
    options.flatten.method = ControllableLaplacian{};
    options.flatten.stopping = Stopping{.max_sweeps = 2};
    return flatten_product(strips_of(900), options);
  }();
  return report;
}

json data_of(const DrawnProduct& drawn, const ProductReport& report = strips_report()) {
  const std::string block = product_data(report, drawn);
  const std::size_t from = block.find('{');
  return json::parse(block.substr(from, block.rfind("</script>") - from));
}

/// The positions of a state, as the script of the page reads them.
std::vector<Vec3> positions_in(const json& states, std::size_t state) {
  const auto places = pages::small_numbers_of(states["positions"][state]);
  std::vector<Vec3> positions;
  for (std::size_t v = 0; v < places.size() / 3; ++v) {
    const auto at = [&](std::size_t axis) {
      return states["low"][axis].get<double>() +
             states["step"][axis].get<double>() * places[3 * v + axis];
    };
    positions.push_back({at(0), at(1), at(2)});
  }
  return positions;
}

double half_a_step(const json& states) {
  double largest = 0.0;
  for (const json& step : states["step"])
    largest = std::max(largest, step.get<double>());
  return 0.5001 * std::sqrt(3.0) * largest;
}

void expect_near(const std::vector<Vec3>& places, const std::vector<Vec3>& expected,
                 std::size_t first, double distance) {
  ASSERT_GE(places.size(), first + expected.size());
  for (std::size_t v = 0; v < expected.size(); ++v)
    EXPECT_LE(norm(places[first + v] - expected[v]), distance) << v;
}

TEST(DrawnProduct, HasEveryPieceInItsPlaceInDesignAndResult) {
  const ProductReport& report = strips_report();
  const std::vector<ProductPatch> input = strips_of(900);
  const json data = data_of(drawn_product(report, k_all));
  const json& states = data["states"];
  EXPECT_EQ(states["names"], json::array({"design", "result"}));
  EXPECT_EQ(states["shown"], 1);
  const std::vector<Vec3> design = positions_in(states, 0), result = positions_in(states, 1);
  const auto corners = pages::small_numbers_of(data["triangles"]["data"]);
  ASSERT_EQ(data["pieces"].size(), report.patches.size());
  std::size_t first = 0, triangle = 0;
  for (std::size_t p = 0; p < report.patches.size(); ++p) {
    const json& piece = data["pieces"][p];
    const TriMesh& mesh = report.patches[p].finished->processed;
    EXPECT_EQ(piece["name"], report.patches[p].name);
    EXPECT_EQ(piece["number"], p + 1);
    ASSERT_EQ(piece["vertices"], mesh.positions.size()) << "few enough to be drawn as they are";
    expect_near(result, mesh.positions, first, half_a_step(states));
    expect_near(design, input[p].mesh.positions, first, half_a_step(states));
    EXPECT_NE(mesh.positions, input[p].mesh.positions);
    for (const Triangle& t : mesh.triangles) {
      for (const Index v : t)
        EXPECT_EQ(corners[triangle++], first + v);
    }
    first += mesh.positions.size();
  }
  EXPECT_EQ(data["vertices"], first);
  EXPECT_EQ(triangle, corners.size());
}

TEST(DrawnProduct, HasTheMiddlesOfPiecesAndOfTheWholeByArea) {
  ProductReport report = strips_report();
  const TriMesh square = {{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}}, {{0, 1, 2}, {0, 2, 3}}};
  const std::array<Vec3, 3> middles = {Vec3{1, 1, 0}, Vec3{11, 1, 0}, Vec3{2, 22, 0}};
  report.seams.clear();
  for (std::size_t p = 0; p < 3; ++p) {
    report.patches[p].design.clear();
    TriMesh& mesh = report.patches[p].finished->processed;
    mesh = square;
    for (Vec3& v : mesh.positions)
      v = middles[p] + (p == 2 ? 2.0 : 1.0) * (v - middles[0]);
  }
  const json data = data_of(drawn_product(report, k_all), report);
  EXPECT_EQ(data["states"]["names"], json::array({"result"})) << "no piece moved";
  for (std::size_t p = 0; p < 3; ++p) {
    const json& middle = data["pieces"][p]["middle"];
    EXPECT_NEAR(middle[0].get<double>(), middles[p].x, 1e-12) << p;
    EXPECT_NEAR(middle[1].get<double>(), middles[p].y, 1e-12) << p;
  }
  // The third square counts as four of the others.
  EXPECT_NEAR(data["middle"][0].get<double>(), (1.0 + 11.0 + 4.0 * 2.0) / 6.0, 1e-12);
  EXPECT_NEAR(data["middle"][1].get<double>(), (1.0 + 1.0 + 4.0 * 22.0) / 6.0, 1e-12);
}

/// With the vertices of a side that are left, from end to end.
void expect_seams_on_pieces(const ProductReport& report, const DrawnProduct& drawn, bool are_all) {
  const json data = data_of(drawn, report);
  const json& states = data["states"];
  const std::vector<Vec3> result = positions_in(states, states["names"].size() - 1);
  std::size_t sides = 0;
  ASSERT_EQ(data["seams"].size(), 2 * report.seams.size());
  for (const json& seam : data["seams"]) {
    const MeasuredSeam& measured = report.seams.at(seam["number"].get<std::size_t>() - 1);
    const std::size_t patch = seam["piece"].get<std::size_t>() - 1;
    const auto vertices = pages::numbers_of(seam["vertices"]);
    for (const SeamSide& side : measured.seam.sides) {
      if (side.patch != patch) continue;
      ++sides;
      const std::vector<Vec3> line =
          line_of(side, report.patches[patch].finished->processed.positions);
      EXPECT_TRUE(!are_all || vertices.size() == side.vertices.size());
      ASSERT_GE(vertices.size(), 2U);
      EXPECT_LE(norm(result[vertices.front()] - line.front()), half_a_step(states));
      EXPECT_LE(norm(result[vertices.back()] - line.back()), half_a_step(states));
      for (const auto v : vertices) {
        double nearest = 1e300;
        for (const Vec3& p : line)
          nearest = std::min(nearest, norm(p - result[v]));
        EXPECT_LE(nearest, half_a_step(states)) << "on the seam";
      }
    }
  }
  EXPECT_EQ(sides, 2 * report.seams.size());
}

TEST(DrawnProduct, HasBothSidesOfEachSeamByItsNumber) {
  ASSERT_EQ(strips_report().seams.size(), 2U);
  expect_seams_on_pieces(strips_report(), drawn_product(strips_report(), k_all), true);
}

TEST(DrawnProduct, KeepsTheSeamsWhereItIsDrawnWithFewerVertices) {
  ProductOptions options;
  options.flatten.stopping = Stopping{.max_sweeps = 0};
  const ProductReport report = flatten_product(strips_of(6000), options);
  const DrawnProduct drawn = drawn_product(report, 1200);
  EXPECT_LE(drawn.mesh.positions.size(), 1500U);
  EXPECT_GE(drawn.mesh.positions.size(), 800U);
  EXPECT_TRUE(drawn.design.empty()) << "no piece moved";
  EXPECT_EQ(data_of(drawn, report)["of"].get<std::size_t>(),
            report.patches[0].vertices + report.patches[1].vertices + report.patches[2].vertices);
  expect_seams_on_pieces(report, drawn, false);
}

TEST(DrawnProduct, LeavesOutWhatFailedAndWhatLiesElsewhere) {
  ProductReport report = strips_report();
  report.patches[2].group = 1;
  DrawnProduct drawn = drawn_product(report, k_all);
  ASSERT_EQ(drawn.pieces.size(), 2U);
  EXPECT_EQ(drawn.pieces[1].patch, 1U);
  EXPECT_THAT(whole_product(report).html, HasSubstr("not in the picture"));
  report.patches[1].finished.reset();
  EXPECT_TRUE(drawn_product(report, k_all).pieces.empty()) << "one alone is no whole";
  EXPECT_EQ(whole_product(report).html, "");
  report.patches[2].group = 0;
  EXPECT_EQ(drawn_product(report, k_all).pieces.size(), 2U);
}

TEST(WholeProduct, SaysWhatItTakesInOneSentence) {
  ProductReport report = strips_report();
  double moved = 0.0, stretch = 0.0;
  for (const PatchResult& piece : report.patches) {
    moved = std::max(moved, piece.finished->deviation.max);
    stretch = std::max(stretch, piece.finished->unfold.strain.p99);
  }
  report.seams[0].on_model = {400.0, 410.0};
  report.seams[1].on_model = {450.0, 450.0};
  EXPECT_EQ(product_sentence(report), "3 pieces, 850\u00A0mm of seam; moves up to " +
                                          length_text(moved, Unit::mm) + "; needs " +
                                          percent_text(stretch) + " of stretch.");
  for (PatchResult& piece : report.patches) {
    piece.finished->deviation = {};
    piece.finished->unfold.strain = {};
  }
  report.seams[0].on_model[0] = 2450.0;
  EXPECT_EQ(product_sentence(report),
            "3 pieces, 2.9\u00A0m of seam; moves 0\u00A0mm; needs no stretch.");
  report.patches.pop_back();
  report.patches.push_back({"sleeve"});
  report.seams.clear();
  EXPECT_EQ(product_sentence(report),
            "3 pieces (1 failed), no seam; moves 0\u00A0mm; needs no stretch.");
}

TEST(WholeProduct, GivesPiecesColoursOfTheirOwn) {
  std::set<std::array<int, 3>> colors;
  for (std::size_t p = 0; p < 12; ++p) {
    const Color color = piece_color(p);
    colors.insert({color.r, color.g, color.b});
  }
  EXPECT_EQ(colors.size(), 12U);
  EXPECT_EQ(piece_color(12), piece_color(0));
  const DrawnProduct drawn = drawn_product(strips_report(), k_all);
  const json data = data_of(drawn);
  for (std::size_t p = 0; p < 3; ++p) {
    const Color color = piece_color(p);
    EXPECT_EQ(data["pieces"][p]["color"], json::array({color.r, color.g, color.b}));
  }
}

}  // namespace
}  // namespace planish
