#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include <planish/mesh/carry.h>

#include <gtest/gtest.h>

#include "support/meshes.h"

namespace planish {
namespace {

/// A prism that is nearly a cylinder, and its pattern, which has the same edges.
struct Cylinder {
  static constexpr std::size_t around = 24, along = 6;
  static constexpr double radius = 2.0, height = 0.7;
  double width = 2.0 * radius * std::sin(0.5 * angle());

  static double angle() { return 1.7 * std::numbers::pi / around; }
  TriMesh form = meshes::flat_grid(around, along), pattern = form;

  Cylinder() {
    for (Vec3& p : form.positions) {
      p = {radius * std::cos(angle() * p.x), radius * std::sin(angle() * p.x), height * p.y};
    }
    for (Vec3& p : pattern.positions)
      p = {width * p.x, height * p.y, 0.0};
  }
};

/// Without the triangles that have all corners in a box of the plane.
TriMesh without(TriMesh mesh, Vec2 low, Vec2 high) {
  std::erase_if(mesh.triangles, [&](const Triangle& t) {
    return std::all_of(t.begin(), t.end(), [&](Index v) {
      const Vec3 p = mesh.positions[v];
      return p.x >= low.x && p.x <= high.x && p.y >= low.y && p.y <= high.y;
    });
  });
  return mesh;
}

TriMesh pressed_flat(TriMesh mesh) {
  for (Vec3& p : mesh.positions)
    p.z = 0.0;
  return mesh;
}

std::vector<Vec3> on(const TriMesh& mesh, const std::vector<SurfacePoint>& places) {
  std::vector<Vec3> points;
  for (const SurfacePoint& place : places)
    points.push_back(position_of(place, mesh.positions));
  return points;
}

DrawnLines on(const TriMesh& mesh, const TracedLines& traced) {
  DrawnLines drawn;
  for (const auto& line : traced.lines)
    drawn.lines.push_back({on(mesh, line)});
  drawn.points = on(mesh, traced.points);
  return drawn;
}

double length_of(const std::vector<Vec3>& line) {
  double sum = 0.0;
  for (std::size_t i = 1; i < line.size(); ++i)
    sum += norm(line[i] - line[i - 1]);
  return sum;
}

double length_of(const DrawnLines& drawn) {
  double sum = 0.0;
  for (const DrawnLine& line : drawn.lines)
    sum += length_of(line.points);
  return sum;
}

/// Of a point from the segment between two others.
double distance(Vec3 p, Vec3 a, Vec3 b) {
  const Vec3 along = b - a;
  const double t = std::clamp(dot(p - a, along) / dot(along, along), 0.0, 1.0);
  return norm(a + t * along - p);
}

TracedLines trace(const TriMesh& mesh, std::vector<Vec3> line) {
  return trace_lines(Patch(mesh), {{{std::move(line)}}, {}});
}

void expect_near(Vec3 a, Vec3 b, double tolerance = 1e-9) {
  EXPECT_LT(norm(a - b), tolerance)
      << a.x << ' ' << a.y << ' ' << a.z << " and " << b.x << ' ' << b.y << ' ' << b.z;
}

/// That every two places which follow each other are on one triangle.
void expect_on_triangles(const TracedLines& traced, const TriMesh& mesh) {
  const auto uses = [](const SurfacePoint& place, const Triangle& t) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (place.shares[k] > 0.0 && std::find(t.begin(), t.end(), place.corners[k]) == t.end())
        return false;
    }
    return true;
  };
  for (const auto& line : traced.lines) {
    ASSERT_GE(line.size(), 2U);
    for (std::size_t i = 1; i < line.size(); ++i) {
      EXPECT_TRUE(std::any_of(mesh.triangles.begin(), mesh.triangles.end(), [&](const auto& t) {
        return uses(line[i - 1], t) && uses(line[i], t);
      })) << i;
    }
  }
}

TEST(Carry, MakesAHelixOfAStraightLine) {
  const Cylinder c;
  const double slope = 0.11;
  const TracedLines traced =
      trace(c.pattern, {{0.0, 0.3, 0.0}, {c.width * 24, 0.3 + slope * 24, 0.0}});
  EXPECT_EQ(traced.outside_length, 0.0);
  ASSERT_EQ(traced.lines.size(), 1U);
  expect_on_triangles(traced, c.pattern);
  const std::vector<Vec3> line = on(c.form, traced.lines[0]);
  std::size_t on_cylinder = 0;
  for (const Vec3 p : line) {
    const double turn = std::atan2(p.y, p.x) / c.angle();
    const double turns = turn < -1e-6 ? turn + 2.0 * std::numbers::pi / c.angle() : turn;
    // Where the pattern's line crosses an upright edge it lies on the cylinder: the helix itself.
    if (std::abs(turns - std::round(turns)) > 1e-7) continue;
    const double n = std::round(turns);
    expect_near(p, {c.radius * std::cos(c.angle() * n), c.radius * std::sin(c.angle() * n),
                    0.3 + slope * n});
    ++on_cylinder;
  }
  EXPECT_EQ(on_cylinder, 25U);
  EXPECT_NEAR(length_of(line), std::hypot(c.width * 24, slope * 24), 1e-12 * 24);
}

TEST(Carry, MakesARulingOfAStraightLine) {
  const Cylinder c;
  // Once through the middle of facets, once along an edge.
  for (const double turn : {7.3, 7.0}) {
    const TracedLines traced =
        trace(c.pattern, {{c.width * turn, 0.0, 0.0}, {c.width * turn, c.height * 6, 0.0}});
    ASSERT_EQ(traced.lines.size(), 1U);
    expect_on_triangles(traced, c.pattern);
    const std::vector<Vec3> line = on(c.form, traced.lines[0]);
    for (const Vec3 p : line)
      expect_near({p.x, p.y, 0.0}, {line[0].x, line[0].y, 0.0});
    expect_near(line.back() - line.front(), {0.0, 0.0, c.height * 6});
  }
}

/// Straight lines over a hilly patch that was pressed flat stay above themselves.
TEST(Carry, KeepsLinesOverTheirPlacesAndComesBack) {
  const TriMesh form = meshes::rough_grid(12, 9, 5, 0.15, 0.4), flat = pressed_flat(form);
  meshes::Random random(11);
  for (int round = 0; round < 60; ++round) {
    const auto some = [&] {
      return Vec3{6.0 + 5.2 * random.number(), 4.5 + 3.8 * random.number()};
    };
    const Vec3 a = some(), b = some();
    const TracedLines traced = trace(flat, {a, b});
    EXPECT_EQ(traced.outside_length, 0.0);
    ASSERT_EQ(traced.lines.size(), 1U);
    expect_on_triangles(traced, flat);
    const DrawnLines formed = on(form, traced);
    for (const Vec3 p : formed.lines[0].points)
      EXPECT_LT(distance({p.x, p.y, 0.0}, a, b), 1e-9);
    const TracedLines again = trace_lines(Patch(form), formed);
    EXPECT_EQ(again.outside_length, 0.0);
    EXPECT_LT(again.farthest, 1e-12);
    ASSERT_EQ(again.lines.size(), 1U);
    expect_on_triangles(again, form);
    const std::vector<Vec3> back = on(flat, again.lines[0]);
    expect_near(back.front(), a);
    expect_near(back.back(), b);
    EXPECT_NEAR(length_of(back), norm(b - a), 1e-9);
    for (const Vec3 p : back)
      EXPECT_LT(distance(p, a, b), 1e-9);
  }
}

TEST(Carry, GoesThroughVerticesAndAlongEdges) {
  const TriMesh flat = meshes::flat_grid(6, 5);
  const TriMesh form = meshes::height_field(6, 5, [](double x, double y) { return 0.1 * x * y; });
  // Along edges, along diagonals, through vertices across triangles, from and to all kinds of
  // place.
  const std::vector<std::array<Vec3, 2>> lines = {
      {{{0, 2, 0}, {6, 2, 0}}},      {{{3, 0, 0}, {3, 5, 0}}},         {{{1, 1, 0}, {4, 4, 0}}},
      {{{4, 1, 0}, {1, 4, 0}}},      {{{0, 0, 0}, {6, 3, 0}}},         {{{0.5, 0, 0}, {0.5, 5, 0}}},
      {{{2.25, 2, 0}, {5.5, 2, 0}}}, {{{1.5, 1.5, 0}, {4.5, 1.5, 0}}}, {{{0, 5, 0}, {6, 5, 0}}}};
  for (const auto& [a, b] : lines) {
    const TracedLines traced = trace(flat, {a, b});
    EXPECT_EQ(traced.outside_length, 0.0);
    ASSERT_EQ(traced.lines.size(), 1U);
    expect_on_triangles(traced, flat);
    const std::vector<Vec3> line = on(flat, traced.lines[0]);
    expect_near(line.front(), a);
    expect_near(line.back(), b);
    EXPECT_NEAR(length_of(line), norm(b - a), 1e-11);
    const TracedLines again = trace_lines(Patch(form), on(form, traced));
    EXPECT_EQ(again.outside_length, 0.0);
    ASSERT_EQ(again.lines.size(), 1U);
    EXPECT_NEAR(length_of(on(flat, again.lines[0])), norm(b - a), 1e-11);
  }
}

TEST(Carry, LeavesAndReentersAConcaveOutline) {
  // A U, 9 wide: its right and left arm are 3 wide, with 3 between them.
  const TriMesh flat = without(meshes::flat_grid(9, 6), {3, 2}, {6, 6});
  const TracedLines traced = trace(flat, {{-1, 4.5, 0}, {10, 4.5, 0}});
  ASSERT_EQ(traced.lines.size(), 2U);
  EXPECT_NEAR(traced.outside_length, 5.0, 1e-9);
  const DrawnLines cut = on(flat, traced);
  expect_near(cut.lines[0].points.front(), {0, 4.5, 0});
  expect_near(cut.lines[0].points.back(), {3, 4.5, 0});
  expect_near(cut.lines[1].points.front(), {6, 4.5, 0});
  expect_near(cut.lines[1].points.back(), {9, 4.5, 0});
  expect_on_triangles(traced, flat);
  // Aslant: out of the left arm at (3, 4), into the right one at (6, 2.5).
  const TracedLines slanting = trace(flat, {{1, 5, 0}, {7, 2, 0}});
  ASSERT_EQ(slanting.lines.size(), 2U);
  EXPECT_NEAR(slanting.outside_length, std::hypot(3.0, 1.5), 1e-9);
}

TEST(Carry, LeavesOutHoles) {
  const TriMesh flat = without(without(meshes::flat_grid(9, 6), {2, 2}, {3, 4}), {5, 2}, {7, 4});
  const TracedLines traced = trace(flat, {{0.5, 3.25, 0}, {8.5, 3.25, 0}});
  ASSERT_EQ(traced.lines.size(), 3U);
  EXPECT_NEAR(traced.outside_length, 3.0, 1e-9);
  EXPECT_NEAR(length_of(on(flat, traced)), 5.0, 1e-9);
}

TEST(Carry, LeavesOutHolesOfASurfaceInSpace) {
  TriMesh form = without(without(meshes::flat_grid(9, 6), {2, 2}, {3, 4}), {5, 2}, {7, 4});
  for (Vec3& p : form.positions)
    p = {p.x, 0.8 * p.y, 0.6 * p.y};
  const TracedLines traced = trace(form, {{0.5, 2.6, 1.95}, {8.5, 2.6, 1.95}});
  ASSERT_EQ(traced.lines.size(), 3U);
  expect_on_triangles(traced, form);
  EXPECT_NEAR(traced.outside_length, 3.0, 1e-9);
  EXPECT_NEAR(length_of(on(form, traced)), 5.0, 1e-9);
  // From beyond the border to beyond it.
  const TracedLines across = trace(form, {{-1, 2.6, 1.95}, {10, 2.6, 1.95}});
  EXPECT_EQ(across.lines.size(), 3U);
  EXPECT_NEAR(across.outside_length, 5.0, 1e-9);
  EXPECT_NEAR(length_of(on(form, across)), 6.0, 1e-9);
}

TEST(Carry, CutsASurfaceInSpaceByAPlane) {
  const Cylinder c;
  // A chord through the cylinder at right angles to its axis: the arc over it comes back.
  const auto at = [&](double n, double z) {
    return Vec3{c.radius * std::cos(c.angle() * n), c.radius * std::sin(c.angle() * n), z};
  };
  const TracedLines traced = trace(c.form, {at(3, 1.1), at(12, 1.1)});
  ASSERT_EQ(traced.lines.size(), 1U);
  EXPECT_EQ(traced.outside_length, 0.0);
  expect_on_triangles(traced, c.form);
  const std::vector<Vec3> flat = on(c.pattern, traced.lines[0]);
  expect_near(flat.front(), {3 * c.width, 1.1, 0.0});
  expect_near(flat.back(), {12 * c.width, 1.1, 0.0});
  for (const Vec3 p : flat)
    EXPECT_NEAR(p.y, 1.1, 1e-9);
}

/// The two sides of a seam are at one place in space and apart in the pattern.
TEST(Carry, KnowsTheSidesOfASeam) {
  Cylinder c;
  // Closed: the first and the last upright border are at one place.
  for (std::size_t v = 0; v < c.form.positions.size(); ++v) {
    const double turn = 2.0 * std::numbers::pi * static_cast<double>(v % 25 % 24) / 24.0;
    c.form.positions[v] = {std::cos(turn), std::sin(turn), c.form.positions[v].z};
  }
  for (const double from : {0.0, 22.5}) {
    const std::vector<Vec3> drawn = {{c.width * from, 1.0, 0.0},
                                     {c.width * (from + 1.5), 2.0, 0.0}};
    const TracedLines traced = trace(c.pattern, drawn);
    const TracedLines again = trace_lines(Patch(c.form), on(c.form, traced));
    ASSERT_EQ(again.lines.size(), 1U);
    const std::vector<Vec3> back = on(c.pattern, again.lines[0]);
    expect_near(back.front(), drawn.front());
    expect_near(back.back(), drawn.back());
  }
}

TEST(Carry, TakesPoints) {
  const TriMesh form = meshes::rough_grid(5, 4, 3, 0.1, 0.3), flat = pressed_flat(form);
  const Vec3 corner = flat.positions[8], middle = 0.5 * (flat.positions[8] + flat.positions[9]);
  const DrawnLines drawn = {{}, {corner, middle, {2.3, 1.7, 0.0}, {9.0, 9.0, 0.0}}};
  const TracedLines traced = trace_lines(Patch(flat), drawn);
  EXPECT_EQ(traced.outside_points, 1U);
  ASSERT_EQ(traced.points.size(), 3U);
  const std::vector<Vec3> points = on(form, traced.points);
  EXPECT_EQ(points[0], form.positions[8]);
  expect_near(points[1], 0.5 * (form.positions[8] + form.positions[9]), 1e-15);
  const TracedLines again = trace_lines(Patch(form), {{}, points});
  for (std::size_t i = 0; i < 3; ++i)
    expect_near(position_of(again.points[i], flat.positions), drawn.points[i], 1e-12);
}

TEST(Carry, CountsWhatIsALittleBeyondTheBorderAsOnIt) {
  const TriMesh flat = meshes::flat_grid(4, 3);
  const TracedLines near = trace(flat, {{0.5, -0.0005, 0}, {3.5, -0.0005, 0}});
  EXPECT_EQ(near.outside_length, 0.0);
  ASSERT_EQ(near.lines.size(), 1U);
  EXPECT_NEAR(length_of(on(flat, near)), 3.0, 1e-12);
  const TracedLines far = trace(flat, {{0.5, -0.05, 0}, {3.5, -0.05, 0}});
  EXPECT_TRUE(far.lines.empty());
  EXPECT_NEAR(far.outside_length, 3.0, 1e-12);
}

TEST(Carry, LeavesOutWhatIsFarFromASurface) {
  const TriMesh form = meshes::height_field(6, 6, [](double x, double) { return 0.2 * x * x; });
  const TracedLines traced =
      trace_lines(Patch(form), {{{{{1, 1, 9}, {5, 5, 19}}}}, {{3, 3, 30}, {3, 3, 2}, {-1, 3, 0}}});
  EXPECT_TRUE(traced.lines.empty());
  EXPECT_GT(traced.outside_length, 5.0);
  EXPECT_EQ(traced.outside_points, 2U);
  EXPECT_EQ(traced.points.size(), 1U);
}

TEST(Carry, IsTheSameInAllSizes) {
  const TriMesh flat = meshes::rough_grid(6, 5, 9, 0.15, 0.0);
  const TracedLines traced = trace(flat, {{0.7, 0.9, 0}, {5.1, 3.3, 0}, {7.0, 3.0, 0}});
  for (const double size : {0x1p-400, 0x1p300}) {
    TriMesh other = flat;
    for (Vec3& p : other.positions)
      p = size * p;
    const TracedLines same = trace(
        other,
        {{0.7 * size, 0.9 * size, 0}, {5.1 * size, 3.3 * size, 0}, {7.0 * size, 3.0 * size, 0}});
    ASSERT_EQ(same.lines.size(), traced.lines.size());
    for (std::size_t i = 0; i < traced.lines[0].size(); ++i)
      EXPECT_EQ(same.lines[0][i].shares, traced.lines[0][i].shares);
    EXPECT_EQ(same.outside_length, size * traced.outside_length);
  }
}

TEST(Carry, StaysOnItsSheetWhereAPatternOverlapsItself) {
  // A strip that is laid back over itself.
  TriMesh flat = meshes::flat_grid(12, 1);
  for (Vec3& p : flat.positions) {
    const double turn = std::numbers::pi / 5.0 * p.x, r = 2.0 + p.y + 0.01 * p.x;
    p = {r * std::cos(turn), -r * std::sin(turn), 0.0};
  }
  for (Triangle& t : flat.triangles)
    std::swap(t[1], t[2]);
  std::vector<Vec3> drawn;
  for (int i = 0; i <= 12; ++i) {
    const double turn = std::numbers::pi / 5.0 * i, r = 2.4 + 0.01 * i;
    drawn.push_back({r * std::cos(turn), -r * std::sin(turn), 0.0});
  }
  const TracedLines traced = trace(flat, drawn);
  EXPECT_LT(traced.outside_length, 1e-9);
  ASSERT_EQ(traced.lines.size(), 1U);
  expect_on_triangles(traced, flat);
}

TEST(Carry, RefusesWhatIsNoPair) {
  const TriMesh mesh = meshes::flat_grid(3, 3);
  TriMesh other = mesh;
  EXPECT_NO_THROW(check_same_triangles(mesh, other));
  std::swap(other.triangles[4], other.triangles[5]);
  EXPECT_THROW(check_same_triangles(mesh, other), Error);
  other.triangles.pop_back();
  EXPECT_THROW(check_same_triangles(mesh, other), Error);
  EXPECT_THROW(trace(mesh, {{0, 0, 0}, {1e9, 0, 0}}), Error);
  EXPECT_TRUE(is_flat(mesh));
  EXPECT_FALSE(is_flat(meshes::fan(5, 0.1)));
}

/// A ring that begins at an angle.
DrawnLines ring(Vec2 middle, double radius, double z, double begin) {
  DrawnLine line;
  constexpr int corners = 30;
  for (int k = 0; k < corners; ++k) {
    const double angle = begin + 2.0 * std::numbers::pi * k / corners;
    line.points.push_back(
        {middle.x + radius * std::cos(angle), middle.y + radius * std::sin(angle), z});
  }
  line.points.push_back(line.points.front());
  return {{line}, {}};
}

TEST(TraceLines, ClosesClosedLinesExactly) {
  for (const double begin : {0.0, 0.3, 1.7, 4.0}) {
    for (const double height : {0.0, 0.02}) {
      const TriMesh flat = meshes::flat_grid(6, 6);
      const TriMesh bent = meshes::height_field(
          6, 6, [&](double x, double y) { return height * (x * x - 0.7 * y * x); });
      const TracedLines traced = trace_lines(Patch(flat), ring({3.0, 2.9}, 1.37, 0.0, begin));
      ASSERT_EQ(traced.lines.size(), 1U);
      for (const TriMesh* mesh : {&flat, &bent}) {
        const std::vector<Vec3> points = on(*mesh, traced.lines[0]);
        EXPECT_EQ(points.front(), points.back());
      }
      const TracedLines back = trace_lines(Patch(bent), on(bent, traced));
      ASSERT_EQ(back.lines.size(), 1U);
      EXPECT_EQ(on(flat, back.lines[0]).front(), on(flat, back.lines[0]).back());
    }
  }
}

TEST(TraceLines, JoinTheEndsOfAClosedLineThatLeavesTheMesh) {
  const TriMesh flat = meshes::flat_grid(6, 6);
  // Over the right border; it begins on the mesh, far from there.
  const TracedLines traced = trace_lines(Patch(flat), ring({5.5, 3.0}, 1.2, 0.0, 2.5));
  ASSERT_EQ(traced.lines.size(), 1U) << "one part, not two that meet where the line began";
  const std::vector<Vec3> points = on(flat, traced.lines[0]);
  EXPECT_NEAR(points.front().x, 6.0, 1e-9);
  EXPECT_NEAR(points.back().x, 6.0, 1e-9);
}

TEST(ChainedLines, JoinsEdgesThatFollowEachOther) {
  const Vec3 a{0, 0, 0}, b{1, 0, 0}, c{2, 0, 0}, d{2, 1, 0}, e{2, -1, 0};
  // a b c in two edges, the second one backwards; three lines meet in c.
  const auto chains = chained_lines({{{a, b}}, {{c, b}}, {{c, d}}, {{c, e}}});
  ASSERT_EQ(chains.size(), 3U);
  EXPECT_EQ(chains[0].points, (std::vector<Vec3>{a, b, c}));
  const auto ring = chained_lines({{{a, b}}, {{b, d}}, {{d, a}}});
  ASSERT_EQ(ring.size(), 1U);
  EXPECT_EQ(ring[0].points.size(), 4U);
  EXPECT_EQ(ring[0].points.front(), ring[0].points.back());
}

TEST(SmoothedLine, HasNoTeethAndKeepsEndsAndCorners) {
  DrawnLine teeth;
  for (int i = 0; i <= 40; ++i)
    teeth.points.push_back({0.5 * i, i % 2 == 0 ? 0.0 : 0.2, 0.0});
  const DrawnLine fair = smoothed_line(teeth, 0.25);
  EXPECT_EQ(fair.points.front(), teeth.points.front());
  EXPECT_EQ(fair.points.back(), teeth.points.back());
  for (std::size_t i = 0; i < fair.points.size(); ++i)
    EXPECT_LE(norm(fair.points[i] - teeth.points[i]), 0.25 * (1.0 + 1e-12));
  EXPECT_GT(length_of(teeth.points), 21.5);
  EXPECT_LT(length_of(fair.points), 20.1);
  EXPECT_EQ(smoothed_line(teeth, 0.0).points, teeth.points);
  DrawnLine corner;
  for (int i = 0; i <= 10; ++i)
    corner.points.push_back({0.1 * i, 0.0, 0.0});
  for (int i = 1; i <= 10; ++i)
    corner.points.push_back({1.0, 0.1 * i, 0.0});
  EXPECT_EQ(smoothed_line(corner, 0.1).points[10], corner.points[10]);
}

}  // namespace
}  // namespace planish
