#include <algorithm>
#include <cmath>
#include <string>

#include <planish/core/error.h>
#include <planish/io/model.h>
#include <planish/mesh/inspect.h>
#include <planish/mesh/patch.h>
#include <planish/mesh/repair.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/meshes.h"
#include "unit/mesh/repair/repairs.h"

namespace planish {
namespace {

using testing::ElementsAre;

Model prepared(TriMesh mesh, const ModelOptions& options = {}) {
  ReadResult file;
  file.mesh = std::move(mesh);
  return prepare_model(std::move(file), options, "sail");
}

/// The cells of a grid left of the column are of the first name, the others of the second one.
FaceGroups halves(const TriMesh& mesh, double column, const std::string& kind) {
  FaceGroups groups{kind, {"left", "right"}, {}};
  for (const Triangle& t : mesh.triangles) {
    const double x = mesh.positions[t[0]].x + mesh.positions[t[1]].x + mesh.positions[t[2]].x;
    groups.of_triangle.push_back(x < 3.0 * column ? 0 : 1);
  }
  return groups;
}

ReadResult grid_with(const std::string& kind) {
  ReadResult file;
  file.mesh = meshes::flat_grid(6, 4);
  (kind == "usemtl" ? file.materials : file.groups) = halves(file.mesh, 3.0, kind);
  return file;
}

/// A small triangle far above the grid, at a place of its own.
TriMesh with_crumbs(TriMesh mesh, int count) {
  for (int k = 0; k < count; ++k) {
    const auto v = static_cast<Index>(mesh.positions.size());
    const Vec3 at = {1.0 * k, 0.0, 5.0};
    for (const Vec3 corner : {Vec3{0, 0, 0}, Vec3{0.1, 0, 0}, Vec3{0, 0.1, 0}})
      mesh.positions.push_back(at + corner);
    mesh.triangles.push_back({v, v + 1, v + 2});
  }
  return mesh;
}

TEST(PrepareModel, LeavesASoundMeshAsItIs) {
  TriMesh mesh = meshes::rough_grid(9, 7, 5);
  mesh.positions.insert(mesh.positions.begin(), {9, 9, 9});  // used by no triangle
  for (Triangle& t : mesh.triangles) {
    for (Index& v : t)
      ++v;
  }
  const Model model = prepared(mesh);
  EXPECT_EQ(model.mesh.positions, mesh.positions);
  EXPECT_EQ(model.mesh.triangles, mesh.triangles);
  EXPECT_THAT(model.pieces, ElementsAre("sail"));
  EXPECT_FALSE(model.work.renumbered);
}

TEST(PrepareModel, DividesByObjectsAndByMaterialsOnRequestOnly) {
  EXPECT_THAT(prepare_model(grid_with("o"), {}, "sail").pieces, ElementsAre("left", "right"));
  EXPECT_THAT(prepare_model(grid_with("usemtl"), {}, "sail").pieces, ElementsAre("sail"));
  EXPECT_THAT(prepare_model(grid_with("usemtl"), {.divide = Divide::materials}, "sail").pieces,
              ElementsAre("left", "right"));
  EXPECT_THAT(prepare_model(grid_with("o"), {.divide = Divide::parts}, "sail").pieces,
              ElementsAre("sail"));
}

/// A quarter of a cylinder, radius 6, with so many rows.
TriMesh bent_grid(std::size_t rows, double height = 0.0) {
  TriMesh mesh = meshes::flat_grid(rows, 4);
  for (Vec3& p : mesh.positions) {
    const double angle = 1.5 * p.x / static_cast<double>(rows);
    p = {6.0 * std::sin(angle), p.y, height + 6.0 * std::cos(angle)};
  }
  return mesh;
}

TEST(PrepareModel, NamesPiecesThatLieOnOthersAllOver) {
  const auto lying = [](const TriMesh& one, const TriMesh& other, const FaceGroups& groups = {}) {
    ReadResult file;
    file.mesh = repairs::both(one, other);
    file.groups = groups;
    std::string found;
    for (const ModelWork::Lying& pair : prepare_model(file, {}, "sail").work.lying)
      found += pair.piece + " on " + pair.on + ";";
    return found;
  };
  const TriMesh sheet = bent_grid(12), finer = turned_over(bent_grid(30));
  TriMesh half = sheet;
  half.triangles.resize(half.triangles.size() / 2);
  EXPECT_EQ(lying(sheet, finer), "sail-2 on sail-1;");
  EXPECT_EQ(lying(half, sheet), "sail-1 on sail-2;");
  EXPECT_EQ(lying(sheet, bent_grid(12, 0.5)), "");
  // Another form in the same box.
  TriMesh across = bent_grid(12);
  for (Vec3& p : across.positions)
    p.z = 6.0 + std::cos(1.5) * 6.0 - p.z;
  EXPECT_EQ(lying(sheet, across), "");
  const auto named = [&](const TriMesh& second) {
    FaceGroups groups{"o", {"front", "lining"}, {}};
    groups.of_triangle.assign(sheet.triangles.size(), 0);
    groups.of_triangle.insert(groups.of_triangle.end(), second.triangles.size(), 1);
    return lying(sheet, second, groups);
  };
  EXPECT_EQ(named(sheet), "lining on front;");
  EXPECT_EQ(named(half), "");
  EXPECT_EQ(named(finer), "");
}

TEST(PrepareModel, LeavesWhatIsThereTwiceInPartToBeRefused) {
  const TriMesh sheet = meshes::rough_grid(6, 6, 10);
  TriMesh mesh = sheet;
  for (std::size_t t = 0; t < sheet.triangles.size() / 2; ++t) {
    const Triangle& corners = sheet.triangles[t];
    mesh.triangles.push_back({corners[0], corners[2], corners[1]});
  }
  const Model model = prepared(mesh);
  EXPECT_EQ(model.mesh.triangles, mesh.triangles);
  EXPECT_THAT(model.pieces, ElementsAre("sail"));
  EXPECT_EQ(inspect(model.mesh).problems.front().code, ErrorCode::duplicate_triangle);
}

TEST(PrepareModel, GivesPiecesVerticesOfTheirOwnBehindAllOthers) {
  const ReadResult file = grid_with("o");
  const Model model = prepare_model(file, {}, "sail");
  EXPECT_EQ(model.mesh.positions, file.mesh.positions);
  const TriMesh apart = divided(model);
  EXPECT_EQ(apart.positions.size(), file.mesh.positions.size() + 5);
  EXPECT_TRUE(
      std::equal(file.mesh.positions.begin(), file.mesh.positions.end(), apart.positions.begin()));
  EXPECT_EQ(Patch(apart).border_loops().size(), 2U);
}

TEST(PrepareModel, NumbersPiecesOfOneName) {
  const TriMesh grid = meshes::flat_grid(3, 3);
  EXPECT_THAT(prepared(meshes::side_by_side(grid, grid)).pieces, ElementsAre("sail-1", "sail-2"));
}

TEST(PrepareModel, TakesALooseSoupForOnePiece) {
  TriMesh soup;
  const TriMesh grid = meshes::flat_grid(3, 3);
  for (const Triangle& t : grid.triangles) {
    const auto v = static_cast<Index>(soup.positions.size());
    for (const Index corner : t)
      soup.positions.push_back(grid.positions[corner]);
    soup.triangles.push_back({v, v + 1, v + 2});
  }
  EXPECT_THAT(prepared(soup).pieces, ElementsAre("sail"));
  const Model welded = prepared(soup, {.weld = 0.0});
  EXPECT_EQ(welded.mesh.positions.size(), grid.positions.size());
  EXPECT_EQ(Patch(welded.mesh).border_loops().size(), 1U);
  EXPECT_EQ(welded.work.joined, 21U) << "all inner edges";
}

TEST(PrepareModel, LeavesCrumbsOutAndCountsThem) {
  const TriMesh grid = meshes::flat_grid(6, 4);
  const Model model = prepared(with_crumbs(grid, 7));
  EXPECT_THAT(model.pieces, ElementsAre("sail"));
  EXPECT_EQ(model.mesh.positions, grid.positions);
  EXPECT_EQ(model.work.crumbs, 7U);
  EXPECT_NEAR(model.work.crumb_share, 7 * 0.005 / (24.0 + 7 * 0.005), 1e-12);
  EXPECT_EQ(prepared(with_crumbs(grid, 7), {.strict = true}).pieces.size(), 8U);
}

TEST(PrepareModel, NeverTakesAPieceWithANameForACrumb) {
  ReadResult file;
  file.mesh = with_crumbs(meshes::flat_grid(6, 4), 1);
  file.groups = {"o", {"sail", "tag"}, std::vector<Index>(file.mesh.triangles.size(), 0)};
  file.groups.of_triangle.back() = 1;
  EXPECT_THAT(prepare_model(file, {}, "x").pieces, ElementsAre("sail", "tag"));
}

TEST(PrepareModel, TakesAndLeavesOutByNames) {
  const Model right = prepare_model(grid_with("o"), {.only = {"right"}}, "sail");
  EXPECT_THAT(right.pieces, ElementsAre("right"));
  EXPECT_EQ(right.mesh.positions.size(), 4U * 5U);
  EXPECT_THAT(prepare_model(grid_with("o"), {.without = {"right"}}, "sail").pieces,
              ElementsAre("left"));
  const Model material = prepare_model(grid_with("usemtl"), {.only = {"left"}}, "sail");
  EXPECT_EQ(material.mesh.triangles.size(), 24U);
  const TriMesh grid = meshes::flat_grid(3, 3);
  const Model second = prepared(meshes::side_by_side(grid, grid), {.only = {"sail-2"}});
  EXPECT_THAT(second.pieces, ElementsAre("sail-2"));
  EXPECT_EQ(second.mesh.triangles, grid.triangles);
  EXPECT_TRUE(prepare_model(grid_with("o"), {.without = {"left", "right"}}, "sail").pieces.empty());
}

ReadResult with_names(const std::vector<std::string>& names) {
  ReadResult file;
  file.groups.kind = "o";
  file.groups.names = names;
  for (std::size_t k = 0; k < names.size(); ++k) {
    TriMesh grid = meshes::flat_grid(3, 3);
    for (Vec3& p : grid.positions)
      p.x += 5.0 * static_cast<double>(k);
    file.mesh = repairs::both(std::move(file.mesh), grid);
    file.groups.of_triangle.resize(file.mesh.triangles.size(), static_cast<Index>(k));
  }
  return file;
}

TEST(PrepareModel, GivesNoTwoPiecesOneName) {
  const std::vector<std::string> names = {"Front", "front", "back", "Front-2"};
  EXPECT_THAT(prepare_model(with_names(names), {}, "suit").pieces,
              ElementsAre("Front", "front-2", "back", "Front-2-2"));
  const Model second = prepare_model(with_names(names), {.only = {"front-2"}}, "suit");
  EXPECT_THAT(second.pieces, ElementsAre("front-2"));
  EXPECT_NO_THROW(check_names({.only = {"front-2"}}, second.names));
  EXPECT_THAT(prepare_model(with_names(names), {.only = {"front"}}, "suit").pieces,
              ElementsAre("front-2"))
      << "the name of the whole file";
}

TEST(PrepareModel, KeepsWhatIsLeftOutInItsPlace) {
  const ReadResult file = with_names({"a", "b", "c", "d"});
  EXPECT_TRUE(prepare_model(file, {}, "suit").left_out.empty());
  for (const ModelOptions& options :
       {ModelOptions{.only = {"b", "d"}}, ModelOptions{.without = {"a", "c"}}}) {
    const Model model = prepare_model(file, options, "suit");
    EXPECT_THAT(model.pieces, ElementsAre("b", "d"));
    ASSERT_EQ(model.left_out.size(), 2U);
    EXPECT_EQ(model.left_out[0].name, "a");
    EXPECT_EQ(model.left_out[0].before, 0U);
    EXPECT_EQ(model.left_out[1].name, "c");
    EXPECT_EQ(model.left_out[1].before, 1U);
    EXPECT_EQ(model.left_out[1].mesh.triangles.size(), 18U);
    EXPECT_EQ(model.left_out[1].mesh.positions.front().x, 10.0);
    EXPECT_THAT(model.names, ElementsAre("a", "b", "c", "d"));
  }
}

TEST(PrepareModel, ClosesHolesOfWhatIsTaken) {
  ReadResult file = with_names({"a", "b"});
  file.mesh.triangles.erase(file.mesh.triangles.begin() + 26);  // in the middle of b
  file.groups.of_triangle.pop_back();
  const Model model = prepare_model(file, {.fill_holes = 4.0, .only = {"b"}}, "suit");
  EXPECT_EQ(model.work.filled, 1U);
  EXPECT_EQ(model.mesh.triangles.size(), 18U);
  EXPECT_THAT(model.pieces, ElementsAre("b"));
  ASSERT_EQ(model.left_out.size(), 1U);
  EXPECT_EQ(model.left_out[0].before, 0U);
}

TEST(PrepareModel, LeavesOutTheRestOfWhatMaterialsDivide) {
  const Model left = prepare_model(grid_with("usemtl"), {.only = {"left"}}, "sail");
  EXPECT_THAT(left.pieces, ElementsAre("sail"));
  EXPECT_TRUE(left.left_out.empty()) << "some of the one piece is taken";
}

TEST(PrepareModel, ListsTheNamesThereAreWhereOneIsNot) {
  const ModelOptions options = {.only = {"middle"}};
  const Model model = prepare_model(grid_with("o"), options, "sail");
  try {
    check_names(options, model.names);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::unknown_name);
    EXPECT_THAT(error.message(), testing::HasSubstr("middle; there are left, right"));
  }
}

TEST(PrepareModel, MendsHarmlessDirtUnlessItIsStrict) {
  TriMesh mesh = meshes::flat_grid(4, 4);
  const TriMesh sound = mesh;
  mesh.triangles.push_back(mesh.triangles[3]);
  mesh.triangles.push_back({0, 1, 1});
  std::swap(mesh.triangles[9][0], mesh.triangles[9][1]);
  const Model model = prepared(mesh);
  EXPECT_EQ(model.work.repeated, 1U);
  EXPECT_EQ(model.work.collapsed, 1U);
  EXPECT_EQ(model.work.turned, 1U);
  EXPECT_EQ(model.mesh.triangles.size(), sound.triangles.size());
  EXPECT_EQ(Patch(model.mesh).border_loops().size(), 1U);
  const Model strict = prepared(mesh, {.strict = true});
  EXPECT_EQ(strict.mesh.triangles, mesh.triangles);
}

TEST(PrepareModel, ClosesHolesOfTheLength) {
  TriMesh mesh = meshes::flat_grid(5, 5);
  mesh.triangles.erase(mesh.triangles.begin() + 24);
  EXPECT_EQ(Patch(prepared(mesh).mesh).border_loops().size(), 2U);
  const Model model = prepared(mesh, {.fill_holes = 4.0});
  EXPECT_EQ(model.work.filled, 1U);
  EXPECT_EQ(Patch(model.mesh).border_loops().size(), 1U);
  EXPECT_EQ(prepared(mesh, {.fill_holes = 3.0}).work.filled, 0U);
}

TEST(PrepareModel, FindsAWallAndTakesASideOfIt) {
  const TriMesh sheet = meshes::flat_grid(30, 20);
  TriMesh other = turned_over(sheet);
  for (Vec3& p : other.positions)
    p.z -= 0.5;
  TriMesh both = sheet;
  for (const Triangle& t : other.triangles) {
    const auto n = static_cast<Index>(sheet.positions.size());
    both.triangles.push_back({t[0] + n, t[1] + n, t[2] + n});
  }
  both.positions.insert(both.positions.end(), other.positions.begin(), other.positions.end());
  const Model model = prepared(both);
  ASSERT_EQ(model.work.walls.size(), 1U);
  EXPECT_NEAR(model.work.walls[0].thickness, 0.5, 1e-12);
  const Model outer = prepared(both, {.side = Side::outer});
  EXPECT_THAT(outer.pieces, ElementsAre("sail"));
  EXPECT_EQ(outer.mesh.positions, sheet.positions);
  EXPECT_TRUE(outer.work.walls.empty());
}

TriMesh above(TriMesh mesh, double x, double z) {
  for (Vec3& p : mesh.positions)
    p = {p.x + x, p.y, p.z + z};
  return mesh;
}

/// A quarter of a cylinder of that thickness, closed by a rim.
TriMesh closed_shell(double thickness) {
  return repairs::closed(repairs::shell(18, 12, 100.0), repairs::shell(18, 12, 100.0 - thickness));
}

TEST(PrepareModel, SaysWhereAWallWithAnOpeningMayBe) {
  TriMesh shell = closed_shell(2.0);
  EXPECT_FALSE(prepared(shell).work.walls.at(0).is_open);
  shell.triangles.erase(shell.triangles.begin() + 40);
  const Model open = prepared(shell);
  ASSERT_EQ(open.work.walls.size(), 1U);
  EXPECT_TRUE(open.work.walls[0].is_open);
  EXPECT_EQ(open.mesh.triangles, shell.triangles) << "nothing is taken unasked";
  EXPECT_TRUE(prepared(repairs::shell(18, 12, 100.0)).work.walls.empty());
}

TEST(PrepareModel, TakesASideOfEachClosedWall) {
  const TriMesh thick = closed_shell(4.0), thin = closed_shell(2.0),
                lone = meshes::flat_grid(40, 40);
  const TriMesh all =
      repairs::both(repairs::both(thick, above(thin, 300.0, 0.0)), above(lone, 600.0, 0.0));
  const Model whole = prepared(all);
  ASSERT_EQ(whole.work.walls.size(), 2U);
  EXPECT_EQ(whole.work.walls[0].name, "sail-1");
  EXPECT_NEAR(whole.work.walls[0].thickness, 4.0, 0.04);
  EXPECT_EQ(whole.work.walls[1].name, "sail-2");
  EXPECT_NEAR(whole.work.walls[1].thickness, 2.0, 0.02);
  const Model outer = prepared(all, {.side = Side::outer});
  EXPECT_EQ(outer.pieces.size(), 3U);
  EXPECT_THAT(outer.work.without_wall, ElementsAre("sail-3"));
  EXPECT_EQ(outer.mesh.triangles.size(), 2U * 432U + 3200U);
  const double quarter = repairs::area(repairs::shell(18, 12, 100.0));
  EXPECT_NEAR(repairs::area(outer.mesh), 2.0 * quarter + 1600.0, 1e-6);
  EXPECT_TRUE(outer.work.level_walls.empty());
  const Model inner = prepared(all, {.side = Side::inner});
  EXPECT_NEAR(repairs::area(inner.mesh), quarter * (0.96 + 0.98) + 1600.0, 1e-6);
}

/// A wall 0.5 thick over a wave, from x to x + 20, as a part of one long sheet.
TriMesh wave_wall(double x, double below = 0.0) {
  const auto sheet = [&](double z) {
    return meshes::height_field(20, 20, [&](double column, double) {
      const double at = (column + x - 20.0) / 20.0;
      return z - below + 4.0 * at * (1.0 - std::abs(at));
    });
  };
  return above(repairs::closed(sheet(0.5), sheet(0.0)), x, 0.0);
}

TEST(PrepareModel, SaysWhereTakenSidesDoNotMeet) {
  ReadResult file;
  file.mesh = repairs::both(wave_wall(0.0), wave_wall(20.0));
  file.groups = {"o", {"left", "right"}, std::vector<Index>(file.mesh.triangles.size(), 0)};
  for (std::size_t t = file.mesh.triangles.size() / 2; t < file.mesh.triangles.size(); ++t)
    file.groups.of_triangle[t] = 1;
  for (const std::vector<std::string>& only :
       {std::vector<std::string>{}, std::vector<std::string>{"right"}}) {
    const Model model = prepare_model(file, {.only = only, .side = Side::outer}, "suit");
    ASSERT_EQ(model.work.clashing_sides.size(), 1U) << only.size();
    EXPECT_EQ(model.work.clashing_sides[0].one, "left");
    EXPECT_EQ(model.work.clashing_sides[0].other, "right");
  }
  EXPECT_TRUE(prepare_model(file, {}, "suit").work.clashing_sides.empty());
  // One lies on the other.
  const TriMesh layers = repairs::both(wave_wall(20.0), wave_wall(20.0, 0.5));
  EXPECT_TRUE(prepared(layers, {.side = Side::outer}).work.clashing_sides.empty());
  // Both bend alike.
  const TriMesh alike = repairs::both(closed_shell(2.0), above(closed_shell(2.0), 0.0, 300.0));
  EXPECT_TRUE(prepared(alike, {.side = Side::outer}).work.clashing_sides.empty());
}

TEST(PrepareModel, SaysWhereNothingTellsTheOuterSide) {
  const TriMesh sheet = meshes::flat_grid(30, 30);
  const TriMesh plate = repairs::closed(sheet, above(sheet, 0.0, -0.5));
  EXPECT_THAT(prepared(plate, {.side = Side::outer}).work.level_walls, ElementsAre("sail"));
  EXPECT_TRUE(prepared(plate).work.level_walls.empty());
}

TEST(PrepareModel, NamesAWallOfTwoTouchingSheetsOfNoOrientation) {
  // Three triangles on one edge are no surface, so nothing is looked for in them.
  const TriMesh fins = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}},
                        {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}};
  const Model model = prepared(fins, {.strict = true, .side = Side::outer});
  EXPECT_THAT(model.work.without_wall, ElementsAre("sail"));
}

TEST(PrepareModel, CountsWhatWeldTurns) {
  const Model both = prepare_model(grid_with("o"), {}, "sail");
  TriMesh mesh = divided(both);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (both.piece_of[t] == 1) std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
  }
  const Model model = prepared(std::move(mesh), {.weld = 0.0});
  EXPECT_THAT(model.pieces, ElementsAre("sail"));
  EXPECT_EQ(model.work.turned, 24U);
}

TEST(PrepareModel, SaysWhatIsNextWhereWeldJoinsNothing) {
  const TriMesh grid = meshes::flat_grid(4, 4);
  const Model apart = prepared(repairs::both(grid, above(grid, 4.3, 0.0)), {.weld = 0.0});
  ASSERT_TRUE(apart.work.nothing_joined);
  EXPECT_NEAR(*apart.work.nothing_joined->gap, 0.3, 1e-12);
  EXPECT_FALSE(apart.work.nothing_joined->is_between_names);
  const Model alone = prepared(grid, {.weld = 0.0});
  ASSERT_TRUE(alone.work.nothing_joined);
  EXPECT_FALSE(alone.work.nothing_joined->gap);
  const Model named = prepare_model(grid_with("o"), {.weld = 0.0}, "sail");
  ASSERT_TRUE(named.work.nothing_joined);
  EXPECT_TRUE(named.work.nothing_joined->is_between_names);
  EXPECT_FALSE(
      prepared(repairs::both(grid, above(grid, 4.0, 0.0)), {.weld = 0.0}).work.nothing_joined);
}

TEST(PrepareModel, TakesManyPiecesForNoWall) {
  TriMesh mesh;
  for (int k = 0; k < 40; ++k) {
    const Index first = static_cast<Index>(mesh.positions.size());
    const double z = 0.5 * k;
    mesh.positions.insert(mesh.positions.end(), {{0, 0, z}, {10, 0, z}, {10, 10, z}, {0, 10, z}});
    mesh.triangles.push_back({first, first + 1, first + 2});
    mesh.triangles.push_back({first, first + 2, first + 3});
  }
  const Model model = prepare_model({mesh, MeshFormat::obj, {}}, {}, "stack");
  EXPECT_TRUE(model.work.walls.empty());
  EXPECT_EQ(model.pieces.size(), 40U);
}

TEST(PrepareModel, LeavesNoPieceWithoutTriangles) {
  const TriMesh collapsed = {{{0, 0, 0}, {1, 0, 0}}, {{0, 1, 1}, {0, 0, 1}}};
  EXPECT_TRUE(prepare_model({collapsed, MeshFormat::obj, {}}, {}, "dust").pieces.empty());
}

TEST(PrepareModel, TurnsTheSurfaceOver) {
  const TriMesh mesh = meshes::flat_grid(4, 4);
  EXPECT_EQ(prepared(mesh, {.flip = true}).mesh.triangles, turned_over(mesh).triangles);
}

TEST(PrepareModel, SaysThatPiecesTouch) {
  TriMesh mesh = divided(prepare_model(grid_with("o"), {}, "sail"));
  const Model model = prepared(mesh);
  EXPECT_EQ(model.work.touching, 2U);
  EXPECT_EQ(model.work.welded, 1U);
  EXPECT_THAT(prepared(mesh, {.weld = 0.0}).pieces, ElementsAre("sail"));
}

TEST(PrepareModel, DividesWhereThreePanelsMeet) {
  TriMesh mesh = meshes::flat_grid(6, 4);
  const auto below = [&](Index j, Index k) {
    return k == 0 ? 7 * j + 3 : static_cast<Index>(35 + 2 * j + k - 1);  // 35: of the grid
  };
  for (Index j = 0; j <= 4; ++j) {
    for (Index k = 1; k <= 2; ++k)
      mesh.positions.push_back({3.0, 1.0 * j, -1.0 * k});
  }
  for (Index j = 0; j < 4; ++j) {
    for (Index k = 0; k < 2; ++k) {
      mesh.triangles.push_back({below(j, k), below(j + 1, k), below(j + 1, k + 1)});
      mesh.triangles.push_back({below(j, k), below(j + 1, k + 1), below(j, k + 1)});
    }
  }
  const Model model = prepared(mesh);
  EXPECT_THAT(model.pieces, ElementsAre("sail-1", "sail-2", "sail-3"));
  EXPECT_EQ(model.work.parted_edges, 4U);
}

TEST(PrepareModel, RefusesLengthsBelowZero) {
  EXPECT_THROW(prepared(meshes::flat_grid(2, 2), {.weld = -1.0}), Error);
  EXPECT_THROW(prepared(meshes::flat_grid(2, 2), {.fill_holes = -1.0}), Error);
}

}  // namespace
}  // namespace planish
