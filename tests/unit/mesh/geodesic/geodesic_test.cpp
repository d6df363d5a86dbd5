#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <planish/mesh/geodesic.h>

#include <gtest/gtest.h>

#include "oracle/plain_geodesic.h"
#include "support/meshes.h"
#include "support/solids.h"

namespace planish {
namespace {

Vec3 position(const TriMesh& mesh, const SurfacePoint& place) {
  return position_of(place, mesh.positions);
}

SurfacePoint at_vertex(const TriMesh& mesh, Index v) {
  for (const Triangle& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      SurfacePoint place{t, {0.0, 0.0, 0.0}};
      place.shares[k] = 1.0;
      if (t[k] == v) return place;
    }
  }
  throw std::logic_error("no such vertex");
}

/// The place of a mesh over the plane z = 0 that is above (x, y).
SurfacePoint above(const TriMesh& mesh, double x, double y) {
  for (const Triangle& t : mesh.triangles) {
    const auto corner = [&](std::size_t k) {
      const Vec3 p = mesh.positions[t[k]];
      return Vec2{p.x - x, p.y - y};
    };
    const Vec2 a = corner(0), b = corner(1), c = corner(2);
    const double area = cross(b - a, c - a);
    const std::array<double, 3> shares = {cross(b, c) / area, cross(c, a) / area,
                                          cross(a, b) / area};
    if (*std::min_element(shares.begin(), shares.end()) >= 0.0) return {t, shares};
  }
  throw std::logic_error("no such place");
}

bool is_on(const SurfacePoint& place, const Triangle& t) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (place.shares[k] > 0.0 && std::find(t.begin(), t.end(), place.corners[k]) == t.end())
      return false;
  }
  return true;
}

/// That two places that follow each other share a triangle, that each between the ends is on an
/// edge or at a vertex as it is promised, and that the length is the sum.
void expect_sound(const TriMesh& mesh, const GeodesicPath& path) {
  ASSERT_GE(path.points.size(), 2U);
  double length = 0.0;
  for (std::size_t i = 1; i < path.points.size(); ++i) {
    const SurfacePoint &a = path.points[i - 1], &b = path.points[i];
    EXPECT_TRUE(std::any_of(mesh.triangles.begin(), mesh.triangles.end(), [&](const Triangle& t) {
      return is_on(a, t) && is_on(b, t);
    })) << i;
    length += norm(position(mesh, b) - position(mesh, a));
    if (i + 1 == path.points.size()) continue;
    EXPECT_EQ(b.shares[2], 0.0);
    EXPECT_EQ(b.shares[0] + b.shares[1], 1.0);
    EXPECT_GT(b.shares[0], 0.0);
  }
  EXPECT_NEAR(path.length, length, 1e-12 * length);
}

double distance(const TriMesh& mesh, const SurfacePoint& from, const SurfacePoint& to) {
  const GeodesicPath path = geodesic(Patch(mesh), from, to);
  expect_sound(mesh, path);
  EXPECT_EQ(norm(position(mesh, path.points.front()) - position(mesh, from)), 0.0);
  EXPECT_EQ(norm(position(mesh, path.points.back()) - position(mesh, to)), 0.0);
  return path.length;
}

void expect_length(double length, double expected) {
  EXPECT_NEAR(length, expected, 1e-12 * expected);
}

TEST(Geodesic, IsAStraightLineInThePlane) {
  const TriMesh mesh = meshes::flat_grid(8, 6);
  // Along edges, through vertices, across, inside one triangle.
  expect_length(distance(mesh, at_vertex(mesh, 9), at_vertex(mesh, 16)), 7.0);
  expect_length(distance(mesh, above(mesh, 0.0, 1.0), above(mesh, 8.0, 5.0)), std::sqrt(80.0));
  expect_length(distance(mesh, above(mesh, 0.3, 0.2), above(mesh, 7.9, 4.1)), std::hypot(7.6, 3.9));
  expect_length(distance(mesh, above(mesh, 0.3, 0.2), above(mesh, 0.9, 0.4)), std::hypot(0.6, 0.2));
  EXPECT_EQ(distance(mesh, at_vertex(mesh, 3), at_vertex(mesh, 3)), 0.0);
}

TEST(Geodesic, GoesAroundTheCornersOfAHole) {
  TriMesh mesh = meshes::flat_grid(6, 6);
  std::erase_if(mesh.triangles, [&](const Triangle& t) {
    return std::all_of(t.begin(), t.end(), [&](Index v) {
      const Vec3 p = mesh.positions[v];
      return p.x >= 2 && p.x <= 4 && p.y >= 2 && p.y <= 4;
    });
  });
  const GeodesicPath path = geodesic(Patch(mesh), above(mesh, 1.0, 2.5), above(mesh, 5.0, 2.5));
  expect_sound(mesh, path);
  expect_length(path.length, 2.0 * std::hypot(1.0, 0.5) + 2.0);
}

TEST(Geodesic, IsKnownOnACube) {
  const TriMesh cube = solids::cube();  // of sides of 2
  const auto middle_of_face = [&](std::size_t first) {
    // Of the diagonal that its two triangles share.
    const Triangle &a = cube.triangles[first], &b = cube.triangles[first + 1];
    SurfacePoint place{a, {0.0, 0.0, 0.0}};
    for (std::size_t k = 0; k < 3; ++k)
      place.shares[k] = std::find(b.begin(), b.end(), a[k]) == b.end() ? 0.0 : 0.5;
    return place;
  };
  expect_length(distance(cube, middle_of_face(0), middle_of_face(2)), 4.0);
  expect_length(distance(cube, middle_of_face(0), middle_of_face(4)), 2.0);
  expect_length(distance(cube, at_vertex(cube, 0), at_vertex(cube, 7)), std::sqrt(20.0));
  expect_length(distance(cube, at_vertex(cube, 0), at_vertex(cube, 3)), std::sqrt(8.0));
}

TEST(Geodesic, GoesAroundAPrismTheShorterWay) {
  constexpr std::size_t around = 16, along = 5;
  const TriMesh tube = meshes::tube(around, along);
  const double side = 2.0 * std::sin(std::numbers::pi / around);
  for (Index i = 0; i < around; ++i) {
    const double steps = std::min<double>(i, around - i);
    expect_length(distance(tube, at_vertex(tube, 0), at_vertex(tube, along * around + i)),
                  std::hypot(steps * side, double{along}));
  }
}

/// Of rim vertices of a fan of equal triangles around vertex 0.
TEST(Geodesic, GoesThroughTheTipOfAConeWhereItIsASaddle) {
  for (const double height : {0.7, 2.0}) {  // a cone; its tip has less than 2 pi
    const TriMesh cone = meshes::fan(24, height);
    const double slant = std::hypot(1.0, height);
    const double step = 2.0 * std::asin(std::sin(std::numbers::pi / 24) / slant);
    for (Index i = 1; i < 24; ++i) {
      const double turn = step * std::min<double>(i, 24 - i);
      // The border cuts straight lines off: they run along it.
      const double beyond =
          turn < std::numbers::pi ? 2.0 * slant * std::sin(0.5 * turn) : 2.0 * slant;
      EXPECT_GE(distance(cone, at_vertex(cone, 1), at_vertex(cone, 1 + i)), beyond * (1 - 1e-12));
    }
    // Of inner rings, from the middles of spokes, they do not.
    for (Index i = 1; i < 24; ++i) {
      const SurfacePoint a{cone.triangles[0], {0.8, 0.2, 0.0}};
      const SurfacePoint b{cone.triangles[i], {0.8, 0.2, 0.0}};
      const double turn = step * std::min<double>(i, 24 - i);
      expect_length(distance(cone, a, b), 0.4 * slant * std::sin(0.5 * turn));
    }
  }
  const TriMesh saddle = meshes::ruffled_fan(8, 0.9);
  const SurfacePoint a{saddle.triangles[0], {0.9, 0.1, 0.0}};
  const SurfacePoint b{saddle.triangles[4], {0.9, 0.1, 0.0}};
  const GeodesicPath path = geodesic(Patch(saddle), a, b);
  expect_sound(saddle, path);
  ASSERT_EQ(path.points.size(), 3U);
  EXPECT_EQ(path.points[1].corners[0], 0U);
  EXPECT_EQ(path.points[1].shares[0], 1.0);
  expect_length(path.length, 0.2 * std::hypot(1.0, 0.9));
}

TEST(Geodesic, IsTheShortestOfAllStrips) {
  std::vector<TriMesh> all = {solids::cube(), meshes::tetrahedron(), meshes::torus(3, 3),
                              meshes::ruffled_fan(9, 0.8)};
  for (std::uint64_t seed = 1; seed <= 6; ++seed)
    all.push_back(meshes::rough_grid(4, 2, seed, 0.3, seed % 2 == 0 ? 0.4 : 1.5));
  TriMesh needles = meshes::rough_grid(4, 2, 7, 0.3, 1.0);
  for (Vec3& p : needles.positions)
    p.y *= 1e-5;
  all.push_back(needles);
  for (const TriMesh& mesh : all) {
    const auto expected = plain_distances(mesh);
    for (Index v = 0; v < mesh.positions.size(); ++v) {
      for (Index w = 0; w < v; ++w)
        EXPECT_NEAR(distance(mesh, at_vertex(mesh, v), at_vertex(mesh, w)), expected[v][w],
                    1e-9 * expected[v][w]);
    }
  }
}

TEST(Geodesic, IsTheSameFromBothEnds) {
  const TriMesh mesh = meshes::rough_grid(20, 20, 3, 0.25, 1.0);
  meshes::Random random(5);
  const auto place = [&] {
    const auto t = static_cast<std::size_t>(400.0 * (random.number() + 1.0));
    const double a = 0.5 * (random.number() + 1.0), b = 0.5 * (1.0 - a) * (random.number() + 1.0);
    return SurfacePoint{mesh.triangles[t], {a, b, 1.0 - a - b}};
  };
  double sum = 0.0;
  for (int i = 0; i < 40; ++i) {
    const SurfacePoint a = place(), b = place();
    const double length = distance(mesh, a, b);
    expect_length(distance(mesh, b, a), length);
    sum += length;
  }
  EXPECT_EQ(sum, 0x1.dde2b4653dc74p+8);  // the same bits everywhere
}

TEST(Geodesic, ScalesWithTheMesh) {
  TriMesh mesh = meshes::rough_grid(6, 6, 3);
  const double length = distance(mesh, at_vertex(mesh, 0), at_vertex(mesh, 48));
  for (Vec3& p : mesh.positions)
    p = 0x1p-600 * p;
  EXPECT_EQ(geodesic(Patch(mesh), at_vertex(mesh, 0), at_vertex(mesh, 48)).length,
            0x1p-600 * length);
}

ErrorCode code_of(const std::function<void()>& call) {
  try {
    call();
  } catch (const Error& error) {
    return error.code();
  }
  throw std::logic_error("no error");
}

TEST(Geodesic, RefusesWhatHasNone) {
  const TriMesh grid = meshes::flat_grid(2, 2), two = meshes::side_by_side(grid, grid);
  const Patch patch(two);
  EXPECT_EQ(code_of([&] { geodesic(patch, at_vertex(two, 0), at_vertex(two, 10)); }),
            ErrorCode::several_components);
  const SurfacePoint good = at_vertex(two, 0);
  for (const SurfacePoint& bad :
       {SurfacePoint{{0, 1, 2}}, SurfacePoint{{0, 1, 100}}, SurfacePoint{{0, 0, 1}},
        SurfacePoint{good.corners, {0.5, 0.6, 0.0}}, SurfacePoint{good.corners, {1.5, -0.5, 0.0}},
        SurfacePoint{good.corners, {std::numeric_limits<double>::quiet_NaN(), 0.5, 0.5}}}) {
    EXPECT_EQ(code_of([&] { geodesic(patch, good, bad); }), ErrorCode::option_out_of_range);
    EXPECT_EQ(code_of([&] {
                straightest(patch, bad, {1, 0, 0}, 1.0);
              }),
              ErrorCode::option_out_of_range);
  }
  const std::vector far = {at_vertex(two, 0), at_vertex(two, 8)}, single = {good};
  EXPECT_EQ(code_of([&] { shortened(patch, far); }), ErrorCode::option_out_of_range);
  EXPECT_EQ(code_of([&] { shortened(patch, single); }), ErrorCode::option_out_of_range);
  EXPECT_EQ(code_of([&] { shortened_loop(patch, far); }), ErrorCode::option_out_of_range);
  TriMesh folded = grid;
  folded.positions[1] = folded.positions[0];
  EXPECT_EQ(code_of([&] { geodesic(Patch(folded), at_vertex(grid, 0), at_vertex(grid, 8)); }),
            ErrorCode::zero_length_edge);
}

TEST(Geodesic, CanBeCancelled) {
  const TriMesh mesh = meshes::rough_grid(20, 20, 3);
  Context context;
  context.is_cancelled = [] { return true; };
  EXPECT_THROW(geodesic(Patch(mesh), at_vertex(mesh, 0), at_vertex(mesh, 440), context), Cancelled);
}

}  // namespace
}  // namespace planish
