#include "mesh/polygon/divide_polygon.h"

#include <numeric>

#include <gtest/gtest.h>

#include "oracle/polygon_division.h"

namespace planish {
namespace {

const std::vector<Vec2> k_l = {{100, 40}, {40, 40}, {40, 100}, {0, 100}, {0, 0}, {100, 0}};
const std::vector<Vec2> k_u = {{0, 0}, {9, 0}, {9, 9}, {6, 9}, {6, 3}, {3, 3}, {3, 9}, {0, 9}};
/// Corners on straight sides, more than one in a row.
const std::vector<Vec2> k_flat_corners = {{0, 0}, {1, 0}, {2, 0}, {4, 0},
                                          {4, 3}, {2, 3}, {0, 3}, {0, 1}};

std::vector<Vec2> comb(int teeth) {
  std::vector<Vec2> places = {{0, 0}, {2.0 * teeth, 0}};
  for (int k = teeth; k > 0; --k) {
    places.push_back({2.0 * k - 0.5, 10.0});
    places.push_back({2.0 * k - 1.5, 1.0});
  }
  return places;
}

std::vector<Vec2> spiral(int corners) {
  std::vector<Vec2> out, in;
  for (int k = 0; k <= corners / 2; ++k) {
    const double angle = 0.25 * k, radius = 5.0 + angle;
    out.push_back({(radius + 1.5) * std::cos(angle), (radius + 1.5) * std::sin(angle)});
    in.push_back({(radius - 1.5) * std::cos(angle), (radius - 1.5) * std::sin(angle)});
  }
  out.insert(out.end(), in.rbegin(), in.rend());
  return out;
}

/// Divides the face from all corners and both ways, flat and tilted, and checks the result.
void expect_divided(const TestFace& flat) {
  for (const TestFace& face : {flat, tilted(flat)}) {
    const auto first = divide_polygon(face.corners, face.positions);
    ASSERT_TRUE(first.has_value());
    for (std::size_t by = 0; by < face.corners.size(); ++by) {
      for (const bool back : {false, true}) {
        const TestFace turned = turned_round(face, by, back);
        const auto triangles = divide_polygon(turned.corners, turned.positions);
        ASSERT_TRUE(triangles.has_value());
        EXPECT_EQ(fault_of_division(turned, *triangles), "") << by << back;
        EXPECT_EQ(sorted_triangles(*triangles), sorted_triangles(*first)) << by << back;
      }
    }
  }
}

TEST(DividePolygon, DividesConcaveFacesInsideThemselves) {
  expect_divided(flat_face(k_l));
  expect_divided(flat_face(k_u));
  expect_divided(flat_face(comb(12)));
  expect_divided(flat_face(spiral(80)));
  expect_divided(flat_face(random_star(40, 0.1, 1)));
}

TEST(DividePolygon, TakesCornersOnStraightSides) {
  expect_divided(flat_face(k_flat_corners));
}

TEST(DividePolygon, MakesTheSameOfMirroredFaces) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const TestFace face = tilted(flat_face(random_star(15, 0.2, seed)));
    const auto own = divide_polygon(face.corners, face.positions);
    TestFace mirrored = turned_round(face, 4, true);
    for (Vec3& p : mirrored.positions)
      p.y = 1234.5 - p.y;
    const auto other = divide_polygon(mirrored.corners, mirrored.positions);
    ASSERT_TRUE(own && other);
    EXPECT_EQ(sorted_triangles(*own), sorted_triangles(*other));
  }
}

TEST(DividePolygon, KeepsHolesThatABridgeLeadsTo) {
  TestFace plate = flat_face({{0, 0},
                              {100, 0},
                              {100, 60},
                              {0, 60},
                              {40, 20},
                              {60, 20},
                              {60, 40},
                              {40, 40},
                              {10, 50},
                              {10, 40},
                              {20, 40},
                              {20, 50}});
  plate.corners = {0, 1, 2, 3, 0, 4, 7, 6, 5, 4};
  expect_divided(plate);
  // A second hole, from the same corner and from another one.
  plate.corners = {0, 1, 2, 3, 8, 11, 10, 9, 8, 3, 0, 4, 7, 6, 5, 4};
  expect_divided(plate);
  plate.corners = {0, 1, 2, 3, 0, 4, 7, 10, 9, 8, 11, 10, 7, 6, 5, 4};
  expect_divided(plate);
}

TEST(DividePolygon, RefusesWhatCrossesItself) {
  const auto divides = [](const TestFace& face) {
    for (const TestFace& any : {face, tilted(face)})
      if (divide_polygon(any.corners, any.positions)) return true;
    return false;
  };
  const TestFace pentagram =
      flat_face({{0, 1}, {0.588, -0.809}, {-0.951, 0.309}, {0.951, 0.309}, {-0.588, -0.809}});
  EXPECT_FALSE(divides(pentagram));
  EXPECT_FALSE(divides(flat_face({{0, 0}, {4, 0}, {1, 2}, {4, 4}, {0, 4}, {3, 2}})));
  // It covers a part twice, and turns once as others do.
  EXPECT_FALSE(divides(
      flat_face({{0, 0}, {9, 0}, {9, 9}, {1, 9}, {1, 6}, {12, 6}, {12, 12}, {-3, 12}, {-3, 0}})));
}

TEST(DividePolygon, RefusesVerticesThatComeTwiceWithoutABridge) {
  TestFace eight = flat_face({{0, 0}, {2, 1}, {2, -1}, {-2, 1}, {-2, -1}});
  eight.corners = {0, 2, 1, 0, 3, 4};
  EXPECT_FALSE(divide_polygon(eight.corners, eight.positions));
  std::vector<Index> again;
  for (Index k = 0; k < 60000; ++k)
    again.push_back(k % 3);
  EXPECT_FALSE(divide_polygon(again, eight.positions));
}

TEST(DividePolygon, LeavesFacesWithoutAreaToOthers) {
  const TestFace line = flat_face({{0, 0}, {1, 2}, {2, 4}, {5, 10}, {3, 6}});
  const auto triangles = divide_polygon(line.corners, line.positions);
  ASSERT_TRUE(triangles.has_value());
  EXPECT_EQ(triangles->size(), 3U);
}

TEST(DividePolygon, DividesLargeFaces) {
  for (const TestFace& face : {flat_face(comb(5000)), flat_face(random_star(10000, 0.5, 3))}) {
    const auto triangles = divide_polygon(face.corners, face.positions);
    ASSERT_TRUE(triangles.has_value());
    EXPECT_EQ(fault_of_division(face, *triangles), "");
  }
}

TEST(DividePolygon, TakesFacesOfAnySizeAndPlace) {
  for (const double size : {1e-150, 1e-30, 1e30, 1e150}) {
    TestFace face = flat_face(k_l);
    for (Vec3& p : face.positions)
      p = size * (p + Vec3{1000.0, 2000.0, 0.0});
    const auto triangles = divide_polygon(face.corners, face.positions);
    ASSERT_TRUE(triangles.has_value()) << size;
    EXPECT_EQ(sorted_triangles(*triangles),
              sorted_triangles(*divide_polygon(face.corners, flat_face(k_l).positions)));
  }
}

// Quads

std::vector<Triangle> quad(const std::vector<Vec2>& places,
                           std::array<Index, 4> corners = {0, 1, 2, 3}) {
  const TestFace face = tilted(flat_face(places));
  const auto halves = divide_quad(corners, face.positions);
  if (!halves) return {};
  return sorted_triangles(*halves);
}

const std::vector<Triangle> k_through_0 = {{0, 1, 2}, {0, 2, 3}};
const std::vector<Triangle> k_through_1 = {{0, 1, 3}, {1, 2, 3}};

TEST(DivideQuad, TakesTheDelaunayDiagonalFromEveryCorner) {
  const std::vector<Vec2> kite = {{0, 0}, {2, -1}, {5, 0}, {2, 1}};
  for (std::size_t by = 0; by < 4; ++by) {
    for (const bool back : {false, true}) {
      const TestFace turned = turned_round(flat_face(kite), by, back);
      const auto& c = turned.corners;
      EXPECT_EQ(quad(kite, {c[0], c[1], c[2], c[3]}), k_through_1);
    }
  }
}

TEST(DivideQuad, DecidesTiesByTheLowestVertex) {
  for (const double noise : {0.0, 1e-7, -1e-7, 1e-4, -1e-4}) {
    const std::vector<Vec2> square = {{0, 0}, {1 + noise, 0}, {1, 1 - noise}, {noise, 1}};
    for (std::size_t by = 0; by < 4; ++by) {
      const auto c = turned_round(flat_face(square), by, by % 2 == 0).corners;
      EXPECT_EQ(quad(square, {c[0], c[1], c[2], c[3]}), k_through_0) << noise;
    }
  }
}

TEST(DivideQuad, StaysInsideConcaveQuads) {
  EXPECT_EQ(quad({{0, 0}, {-1, 4}, {0, 9}, {-9, 4}}), k_through_1);  // a nook at 1
  EXPECT_EQ(quad({{0, 0}, {9, 0}, {1, 1}, {0, 9}}), k_through_0);
  EXPECT_EQ(quad({{0, 0}, {4, 0}, {4, 4}, {2, 2}}), k_through_1);  // straight at 3
}

TEST(DivideQuad, RefusesQuadsThatCrossThemselves) {
  EXPECT_TRUE(quad({{0, 0}, {1, 1}, {1, 0}, {0, 1}}).empty());
  EXPECT_TRUE(quad({{0, 0}, {3, 1}, {3, 0}, {0, 1.5}}).empty());
}

TEST(DivideQuad, LeavesQuadsWithoutAreaToOthers) {
  EXPECT_EQ(quad({{0, 0}, {1, 0}, {2, 0}, {3, 0}}).size(), 2U);
  EXPECT_EQ(quad({{0, 0}, {0, 0}, {2, 0}, {0, 3}}).size(), 2U);
  EXPECT_EQ(quad({{1, 1}, {1, 1}, {1, 1}, {1, 1}}).size(), 2U);
}

}  // namespace
}  // namespace planish
