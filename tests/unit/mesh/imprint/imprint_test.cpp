#include <algorithm>
#include <cmath>

#include <planish/io/read_mesh.h>
#include <planish/mesh/carry.h>
#include <planish/mesh/cut.h>
#include <planish/mesh/imprint.h>
#include <planish/mesh/shapes.h>

#include <gtest/gtest.h>

#include "lines/line_checks.h"
#include "support/meshes.h"

namespace planish {
namespace {

/// What holds of every imprint.
lines::Figures expect_sound(const ImprintedMesh& imprinted, const Patch& patch,
                            std::span<const SurfaceLine> drawn) {
  lines::Figures figures;
  EXPECT_EQ(lines::wrong_imprint(patch, drawn, imprinted, figures), "");
  return figures;
}

std::vector<SurfaceLine> traced(const Patch& patch, const std::vector<std::vector<Vec3>>& drawn) {
  DrawnLines lines;
  for (const auto& line : drawn)
    lines.lines.push_back({line});
  std::vector<SurfaceLine> result;
  for (auto& line : trace_lines(patch, lines).lines)
    result.push_back(std::move(line));
  return result;
}

Vec3 random_place(const TriMesh& mesh, meshes::Random& random) {
  const auto pick = static_cast<std::size_t>((0.5 + 0.5 * random.number()) *
                                             static_cast<double>(mesh.triangles.size()));
  const Triangle& t = mesh.triangles[std::min(pick, mesh.triangles.size() - 1)];
  double a = 0.5 + 0.5 * random.number(), b = 0.5 + 0.5 * random.number();
  if (a + b > 1.0) a = 1.0 - a, b = 1.0 - b;
  return position_of(SurfacePoint{t, {1.0 - a - b, a, b}}, mesh.positions);
}

void try_random_lines(const TriMesh& mesh, std::size_t lines, std::uint64_t seed,
                      double most_slivers) {
  const Patch patch(mesh);
  meshes::Random random(seed);
  std::vector<std::vector<Vec3>> drawn;
  for (std::size_t k = 0; k < lines; ++k) {
    drawn.push_back({random_place(mesh, random), random_place(mesh, random)});
    if (k % 3 == 0) drawn.back().push_back(random_place(mesh, random));
  }
  const std::vector<SurfaceLine> on_mesh = traced(patch, drawn);
  const ImprintedMesh imprinted = imprint(patch, on_mesh);
  const lines::Figures figures = expect_sound(imprinted, patch, on_mesh);
  EXPECT_LE(figures.thin_share(), most_slivers);
  // Where no angle of lines and edges is so small itself, there are hardly any.
  EXPECT_LE(static_cast<double>(figures.thin - figures.given),
            0.005 * static_cast<double>(figures.triangles));
}

TEST(Imprint, OfALineThroughOneTriangle) {
  const TriMesh mesh = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  const Patch patch(mesh);
  const std::vector<SurfaceLine> lines = {
      {{{0, 1, 2}, {0.5, 0.5, 0.0}}, {{1, 2, 0}, {0.25, 0.75, 0.0}}}};
  const ImprintedMesh imprinted = imprint(patch, lines, {.least_angle = 0.0});
  expect_sound(imprinted, patch, lines);
  EXPECT_EQ(imprinted.mesh.triangles.size(), 3U);
  EXPECT_EQ(imprinted.paths[0], (std::vector<Index>{3, 4}));
  EXPECT_EQ(imprinted.mesh.positions[3], (Vec3{0.5, 0.0, 0.0}));
  EXPECT_EQ(imprinted.mesh.positions[4], (Vec3{0.25, 0.75, 0.0}));
}

TEST(Imprint, OfNothingIsTheMesh) {
  const TriMesh mesh = meshes::flat_grid(3, 3);
  const ImprintedMesh imprinted = imprint(Patch(mesh), {});
  EXPECT_EQ(imprinted.mesh.triangles, mesh.triangles);
  EXPECT_EQ(imprinted.mesh.positions, mesh.positions);
}

TEST(Imprint, LinesThatCrossShareAVertex) {
  const TriMesh mesh = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  const std::vector<SurfaceLine> lines = {
      {{{0, 1, 2}, {0.7, 0.3, 0.0}}, {{0, 1, 2}, {0.0, 0.4, 0.6}}},
      {{{0, 1, 2}, {0.6, 0.0, 0.4}}, {{0, 1, 2}, {0.0, 0.7, 0.3}}}};
  const Patch patch(mesh);
  const ImprintedMesh imprinted = imprint(patch, lines, {.least_angle = 0.0});
  expect_sound(imprinted, patch, lines);
  ASSERT_EQ(imprinted.paths[0].size(), 3U);
  ASSERT_EQ(imprinted.paths[1].size(), 3U);
  EXPECT_EQ(imprinted.paths[0][1], imprinted.paths[1][1]);
}

TEST(Imprint, RandomLines) {
  try_random_lines(meshes::flat_grid(7, 5), 40, 1, 0.05);
  try_random_lines(make_shape("dome", 2000), 20, 2, 0.02);
  try_random_lines(make_shape("cylinder", 1000), 20, 3, 0.02);
  try_random_lines({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}, 60, 4, 1.0);
}

TEST(Imprint, PlaneSectionOfAGridIsStraight) {
  const TriMesh mesh = meshes::height_field(
      20, 20, [](double x, double y) { return 0.1 * x * (20.0 - x) * 0.1 + 0.02 * y * y; });
  const Patch patch(mesh);
  const auto lines = plane_section(patch, {{1.0, 0.3, 0.0}, 10.0});
  ASSERT_EQ(lines.size(), 1U);
  const ImprintedMesh imprinted = imprint(patch, lines);
  const lines::Figures figures = expect_sound(imprinted, patch, lines);
  for (const SurfacePoint& point : lines[0]) {
    const Vec3 p = position_of(point, mesh.positions);
    EXPECT_NEAR(p.x + 0.3 * p.y, 10.0, 1e-12);
  }
  EXPECT_LE(figures.thin_share(), 0.01);
}

TEST(Imprint, PlaneSectionAlongEdgesFollowsThem) {
  const TriMesh mesh = meshes::flat_grid(4, 4);
  const Patch patch(mesh);
  const auto lines = plane_section(patch, {{1.0, 0.0, 0.0}, 2.0});
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(lines[0].size(), 5U);
  EXPECT_TRUE(plane_section(patch, {{1.0, 0.0, 0.0}, 0.0}).empty());
  EXPECT_TRUE(plane_section(patch, {{1.0, 0.0, 0.0}, 9.0}).empty());
  const ImprintedMesh imprinted = imprint(patch, lines);
  EXPECT_EQ(imprinted.mesh.triangles, mesh.triangles);
  EXPECT_EQ(imprinted.paths[0].size(), 5U);
}

TEST(Imprint, ClosedSectionEndsWhereItBegins) {
  const TriMesh mesh = meshes::tube(40, 12);
  const Patch patch(mesh);
  const auto lines = plane_section(patch, {{0.05, 0.02, 1.0}, 1.7});
  ASSERT_EQ(lines.size(), 1U);
  const ImprintedMesh imprinted = imprint(patch, lines);
  ASSERT_GT(imprinted.paths[0].size(), 20U);
  EXPECT_EQ(imprinted.paths[0].front(), imprinted.paths[0].back());
}

TEST(CreaseLines, AreTheEdgesOfARoof) {
  // A ridge at x = 3 that fades towards y = 8.
  const TriMesh mesh = meshes::height_field(
      6, 8, [](double x, double y) { return (1.0 - 0.11 * y) * (3.0 - std::abs(x - 3.0)); });
  const Patch patch(mesh);
  const auto lines = crease_lines(patch, 45.0);
  ASSERT_EQ(lines.size(), 1U);
  for (const SurfacePoint& point : lines[0])
    EXPECT_EQ(position_of(point, mesh.positions).x, 3.0);
  EXPECT_GE(lines[0].size(), 6U) << "weaker edges lead on";
  EXPECT_TRUE(crease_lines(Patch(meshes::flat_grid(4, 4))).empty());
  EXPECT_THROW(crease_lines(patch, 0.0), Error);
}

TEST(JoinLines, LeadsEndsOnToLinesAndTheBorder) {
  const TriMesh mesh = meshes::flat_grid(10, 10);
  const Patch patch(mesh);
  const auto line = [&](Vec3 a, Vec3 b) { return traced(patch, {{a, b}}).at(0); };
  // The second ends 0.3 before the first and 0.2 before the border.
  const JoinedLines joined = join_lines(
      patch, {line({0.0, 5.2, 0.0}, {10.0, 5.2, 0.0}), line({4.3, 4.9, 0.0}, {4.3, 0.2, 0.0})},
      0.5);
  ASSERT_EQ(joined.joined.size(), 2U);
  EXPECT_EQ(joined.joined[0].line, 1U);
  EXPECT_FALSE(joined.joined[0].is_last);
  EXPECT_NEAR(joined.joined[0].distance, 0.3, 1e-9);
  EXPECT_EQ(joined.joined[0].to, 0U);
  EXPECT_TRUE(joined.joined[1].is_last);
  EXPECT_FALSE(joined.joined[1].to);
  const ImprintedMesh imprinted = imprint(patch, joined.lines);
  const auto &first = imprinted.paths[0], &second = imprinted.paths[1];
  EXPECT_NE(std::find(first.begin(), first.end(), second.front()), first.end());
  EXPECT_EQ(imprinted.mesh.positions[second.back()].y, 0.0);
  EXPECT_EQ(cut_open(Patch(imprinted.mesh), std::vector<CutPath>{{first}, {second}})
                .mesh.positions.size(),
            imprinted.mesh.positions.size() + first.size() + second.size());
}

TEST(JoinLines, LeadsAheadWhereALineRunsBesideAnother) {
  const TriMesh mesh = meshes::flat_grid(20, 10);
  const Patch patch(mesh);
  const auto line = [&](Vec3 a, Vec3 b) { return traced(patch, {{a, b}}).at(0); };
  const JoinedLines joined = join_lines(
      patch, {line({0.0, 5.2, 0.0}, {20.0, 5.2, 0.0}), line({8.0, 5.5, 0.0}, {12.0, 5.5, 0.0})},
      0.5);
  ASSERT_EQ(joined.joined.size(), 2U);
  EXPECT_NEAR(joined.joined[0].distance, 0.3, 1e-9);
  const Vec3 first = position_of(joined.lines[1].front(), mesh.positions),
             last = position_of(joined.lines[1].back(), mesh.positions);
  EXPECT_NEAR(norm(first - Vec3{8.0 - 1.8, 5.2, 0.0}), 0.0, 1e-9);
  EXPECT_NEAR(norm(last - Vec3{12.0 + 1.8, 5.2, 0.0}), 0.0, 1e-9);
  expect_sound(imprint(patch, joined.lines), patch, joined.lines);
  // Not beyond the end of the other line.
  const JoinedLines shorter = join_lines(
      patch, {line({0.0, 5.2, 0.0}, {13.0, 5.2, 0.0}), line({8.0, 5.5, 0.0}, {12.0, 5.5, 0.0})},
      0.5);
  EXPECT_NEAR(norm(position_of(shorter.lines[1].back(), mesh.positions) - Vec3{13.0, 5.2, 0.0}),
              0.0, 1e-9);
}

TEST(JagOf, IsOfTeethAndBends) {
  EXPECT_EQ(jag_of({}, 1.0), 1.0);
  std::vector<Vec3> straight, teeth, round;
  for (int k = 0; k <= 400; ++k) {
    const double turn = 0.0174532925199433 * 0.9 * k;
    straight.push_back({0.1 * k, 0.0, 0.0});
    teeth.push_back({0.1 * k, k % 2 == 0 ? 0.0 : 0.1, 0.0});
    round.push_back({10.0 * std::cos(turn), 10.0 * std::sin(turn), 0.0});
  }
  EXPECT_NEAR(jag_of(straight, 1.0), 1.0, 1e-12);
  EXPECT_NEAR(jag_of(teeth, 1.0), std::sqrt(2.0), 1e-3);
  const double chord = 62.83 / 16.0;  // round(62.83 / 4) parts
  EXPECT_NEAR(jag_of(round, 1.0) - 1.0, chord * chord / 2400.0, 1e-4);
  EXPECT_EQ(jag_of(round, 40.0), 1.0);
}

TEST(JoinLines, LeavesWhatIsFarAndWhatMeetsAlready) {
  const Patch patch(meshes::flat_grid(10, 10));
  const auto line = [&](Vec3 a, Vec3 b) { return traced(patch, {{a, b}}).at(0); };
  const auto far = join_lines(patch, {line({2.0, 3.0, 0.0}, {2.0, 6.1, 0.0})}, 0.5);
  EXPECT_TRUE(far.joined.empty());
  ASSERT_EQ(far.free.size(), 2U);
  EXPECT_NEAR(far.free[1].distance, 2.0, 1e-12);
  EXPECT_FALSE(far.free[1].to);
  const auto closed = traced(patch, {{{3, 3, 0}, {6, 3, 0}, {6, 6, 0}, {3, 3, 0}}});
  EXPECT_TRUE(join_lines(patch, closed, 5.0).joined.empty());
}

TEST(SingleLines, LeaveOutWhatRunsBesideOthers) {
  const Patch patch(meshes::flat_grid(20, 10));
  const auto line = [&](std::vector<Vec3> points) { return traced(patch, {points}).at(0); };
  const SingleLines single = single_lines(
      patch,
      {line({{0.0, 5.2, 0.0}, {20.0, 5.2, 0.0}}),
       line({{2.0, 0.0, 0.0}, {8.0, 5.23, 0.0}, {14.0, 5.23, 0.0}, {19.0, 10.0, 0.0}}),
       line({{3.0, 10.0, 0.0}, {7.0, 0.0, 0.0}}),
       line({{10.0, 10.0, 0.0}, {10.0, 9.97, 0.0}, {18.0, 9.97, 0.0}, {18.0, 7.0, 0.0}})},
      0.05);
  EXPECT_EQ(single.of, (std::vector<std::size_t>{0, 1, 1, 2, 3}));
  ASSERT_EQ(single.doubled.size(), 2U);
  EXPECT_EQ(single.doubled[0].line, 1U);
  EXPECT_EQ(single.doubled[0].beside, 0U);
  EXPECT_NEAR(single.doubled[0].length, 6.0, 0.2);
  EXPECT_EQ(single.doubled[1].line, 3U);
  EXPECT_FALSE(single.doubled[1].beside);
  // What is left ends beside the line that took its place, and is joined to it.
  const JoinedLines joined = join_lines(patch, single.lines, 0.1);
  EXPECT_EQ(joined.joined.size(), 3U);
  expect_sound(imprint(patch, joined.lines), patch, joined.lines);
}

TEST(SingleLines, KeepWhatCrossesAndTheBorderItself) {
  const Patch patch(meshes::flat_grid(20, 10));
  std::vector<Index> border;
  for (Index v = 0; v <= 20; ++v)
    border.push_back(v);
  const std::vector<SurfaceLine> lines = {
      traced(patch, {{{0.0, 1.0, 0.0}, {20.0, 9.0, 0.0}}}).at(0),
      traced(patch, {{{0.0, 9.0, 0.0}, {20.0, 1.0, 0.0}}}).at(0), line_along_edges(patch, border)};
  const SingleLines single = single_lines(patch, lines, 0.05);
  EXPECT_TRUE(single.doubled.empty());
  EXPECT_EQ(single.lines.size(), 3U);
}

TEST(NearestPlace, IsTheFootOnTheMesh) {
  const Patch patch(meshes::flat_grid(4, 4));
  EXPECT_EQ(position_of(nearest_place(patch, {2.25, 1.5, 7.0}), patch.positions()),
            (Vec3{2.25, 1.5, 0.0}));
  EXPECT_EQ(position_of(nearest_place(patch, {-3.0, 1.0, 0.0}), patch.positions()),
            (Vec3{0.0, 1.0, 0.0}));
  EXPECT_THROW(nearest_place(patch, {std::nan(""), 0.0, 0.0}), Error);
}

TEST(Imprint, RefusesLinesThatAreNotOnTheMesh) {
  const Patch patch(meshes::flat_grid(4, 4));
  const SurfacePoint here = nearest_place(patch, {0.6, 0.3, 0.0}),
                     there = nearest_place(patch, {3.6, 3.3, 0.0});
  const auto error_of = [&](const SurfaceLine& line) {
    try {
      imprint(patch, std::vector<SurfaceLine>{{here}, line});
    } catch (const Error& error) {
      EXPECT_EQ(error.place().first, 1U);
      return error.message();
    }
    return std::string();
  };
  EXPECT_EQ(error_of({here, there}),
            "line 2: two points of it that follow each other are on no triangle together");
  EXPECT_EQ(error_of({{{0, 1, 7}, {1.0, 0.0, 0.0}}}),
            "line 2: a point of it is on no triangle of the mesh");
  EXPECT_EQ(error_of({{{0, 1, 99}, {1.0, 0.0, 0.0}}}),
            "line 2: it names a vertex that the mesh does not have");
  SurfacePoint bad = here;
  bad.shares[0] = std::nan("");
  EXPECT_EQ(error_of({bad}), "line 2: a point of it is on no triangle of the mesh");
}

TEST(Imprint, OfALineThatIsOnePlaceHasOneVertex) {
  const TriMesh mesh = meshes::flat_grid(2, 2);
  const Patch patch(mesh);
  const SurfacePoint inside{mesh.triangles[0], {0.3, 0.3, 0.4}},
      at_corner{mesh.triangles[0], {0.0, 1.0 - 1e-12, 1e-12}};
  const std::vector<SurfaceLine> lines = {{inside}, {at_corner, at_corner}, {}};
  const ImprintedMesh imprinted = imprint(patch, lines);
  expect_sound(imprinted, patch, lines);
  EXPECT_EQ(imprinted.paths[0], (std::vector<Index>{9}));
  EXPECT_EQ(imprinted.paths[1], (std::vector<Index>{mesh.triangles[0][1]}));
  EXPECT_TRUE(imprinted.paths[2].empty());
}

TEST(Imprint, PointsNearAVertexBetweenTwoTrianglesStay) {
  const TriMesh mesh = meshes::flat_grid(3, 3);
  const Patch patch(mesh);
  // Beside vertex 5 by 1e-10: in a triangle that the next point is not on.
  const std::vector<SurfaceLine> lines = {{{{0, 5, 4}, {0.0, 0.9, 0.1}},
                                           {{0, 5, 4}, {1e-11, 1.0 - 1.3e-10, 1.2e-10}},
                                           {{5, 6, 10}, {0.9, 0.1, 0.0}}}};
  const ImprintedMesh imprinted = imprint(patch, lines);
  expect_sound(imprinted, patch, lines);
  ASSERT_EQ(imprinted.paths[0].size(), 3U);
  EXPECT_EQ(imprinted.paths[0][1], 5U);
}

TEST(Imprint, KeepsLinesThatTurnBack) {
  const TriMesh mesh = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  const Patch patch(mesh);
  const auto at = [&](double x, double y) {
    return SurfacePoint{mesh.triangles[0], {1.0 - x - y, x, y}};
  };
  const std::vector<SurfaceLine> lines = {{at(0.1, 0.3), at(0.5, 0.3), at(0.2, 0.3), at(0.6, 0.3)}};
  expect_sound(imprint(patch, lines), patch, lines);
}

TEST(Imprint, PointsBesideALineTogetherLeadItNoFartherThanIsSaid) {
  const TriMesh mesh = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  const Patch patch(mesh);
  const auto at = [&](double x, double y) {
    return SurfacePoint{mesh.triangles[0], {1.0 - x - y, x, y}};
  };
  // Each is near to the straight way on from the one before, and farther from the line.
  constexpr double step = 6e-6;
  std::vector<SurfaceLine> lines = {{at(0.1, 0.2), at(0.7, 0.2)}};
  double aside = 0.0;
  for (int k = 1; k < 20; ++k) {
    aside = aside * (20 - k) / (21 - k) + step;
    lines.push_back({at(0.1 + 0.03 * k, 0.2 + aside)});
  }
  const ImprintedMesh imprinted = imprint(patch, lines);
  expect_sound(imprinted, patch, lines);
  double farthest = 0.0;
  for (const Index v : imprinted.paths[0])
    farthest = std::max(farthest, std::abs(imprinted.mesh.positions[v].y - 0.2));
  EXPECT_GT(farthest, step);
  EXPECT_LE(farthest, 1.01 * imprinted.farthest_snap);
  EXPECT_LE(farthest, 1e-5 * bounding_box_diagonal(mesh));
}

}  // namespace
}  // namespace planish
