// What mends meshes, on files that makers left behind. Meshes of the same kinds that are made by
// formula are in tests/unit/mesh/repair/.

#include <string>

#include <planish/mesh/inspect.h>
#include <planish/mesh/repair.h>
#include <planish/mesh/wall.h>
#include <planish/mesh/weld.h>

#include <gtest/gtest.h>

#include "support/test_files.h"
#include "unit/mesh/repair/repairs.h"

namespace planish {
namespace {

class OddMeshes : public WithOddFiles<> {};

TEST_F(OddMeshes, LoseTheirCrumbs) {
  const Crumbs crumbs = find_crumbs(mesh_of("odd/scan_with_crumbs.obj"));
  EXPECT_EQ(crumbs.pieces, 40U);
  EXPECT_NEAR(crumbs.area_share, 0.0028, 0.0001);
  EXPECT_EQ(find_crumbs(mesh_of("bad/top_triangle_soup.obj")).pieces, 0U);
}

TEST_F(OddMeshes, AreClosedWhereATriangleIsMissing) {
  const TriMesh mesh = mesh_of("odd/one_triangle_missing.obj");
  const FilledMesh filled = fill_holes(mesh, 50.0);
  EXPECT_EQ(filled.filled, 1U);
  EXPECT_EQ(filled.mesh.triangles.size(), mesh.triangles.size() + 1);
  EXPECT_TRUE(repairs::is_disk(filled.mesh));
}

TEST_F(OddMeshes, AreOrientedByTheMajority) {
  const OrientedMesh oriented = orient_consistently(mesh_of("bad/top_one_face_flipped.obj"));
  EXPECT_EQ(oriented.turned, 1U);
  EXPECT_TRUE(repairs::is_disk(oriented.mesh));
}

TEST_F(OddMeshes, LoseWhatIsThereTwice) {
  EXPECT_EQ(remove_redundant_triangles(mesh_of("odd/facet_twice.stl")).repeated, 1U);
  EXPECT_EQ(remove_redundant_triangles(mesh_of("odd/quads_and_their_triangles.obj")).repeated, 8U);
  EXPECT_EQ(remove_redundant_triangles(mesh_of("odd/flap_of_five.obj")).fins, 5U);
  for (const char* name :
       {"odd/double_sided_shared_vertices.obj", "odd/double_sided_own_vertices.obj"}) {
    const CleanedMesh clean = remove_redundant_triangles(mesh_of(name));
    EXPECT_EQ(clean.backs, 192U) << name;
    EXPECT_TRUE(repairs::is_disk(clean.mesh)) << name;
  }
}

TEST_F(OddMeshes, AreDividedWherePartsMeet) {
  const SeparatedMesh divided =
      divide_at_nonmanifold_edges(mesh_of("odd/three_panels_one_edge_groups.obj"));
  EXPECT_EQ(divided.places, 10U);
  EXPECT_EQ(inspect(divided.mesh).topology.components, 3U);
  const TriMesh dropouts = mesh_of("odd/dropouts_touch_at_vertex.obj");
  EXPECT_EQ(fill_holes(separate_touching(dropouts).mesh, 1e9).filled, 2U);
  EXPECT_EQ(separate_touching(mesh_of("bad/top_bowtie_vertex.obj")).places, 1U);
}

TEST_F(OddMeshes, AreWallsWhereTheyHaveAThickness) {
  for (const char* name :
       {"odd/thick_shell_2mm.obj", "odd/thick_shell_2mm.stl", "odd/two_sheets_2mm_apart.obj"}) {
    const TriMesh mesh = mesh_of(name);
    const auto wall = find_wall(mesh);
    ASSERT_TRUE(wall) << name;
    EXPECT_NEAR(wall->thickness, 2.0, 0.02) << name;
    const RepairedMesh outer = take_side(mesh, *wall, WallPart::outer);
    EXPECT_EQ(outer.mesh.triangles.size(), 320U) << name;
    EXPECT_EQ(take_side(mesh, *wall, WallPart::inner).mesh.triangles.size(), 320U) << name;
    EXPECT_TRUE(repairs::has_sources(outer, mesh)) << name;
    // An arc of 209.29 as it is meshed, by 150.
    EXPECT_NEAR(repairs::area(outer.mesh), 209.29 * 150.0, 1.0) << name;
  }
  for (const char* name : {"bad/top_closed_fox.obj", "bad/top_punctured_torus.obj",
                           "odd/panel_and_helper_cubes.obj", "odd/frustum_capped_ngon.obj"}) {
    EXPECT_FALSE(find_wall(mesh_of(name))) << name;
  }
}

TEST_F(OddMeshes, AreWeldedToOneDisk) {
  for (const char* name : {"odd/split_at_texture_islands.ply", "odd/polysurface_two_faces.obj",
                           "bad/top_triangle_soup.obj", "bad/stl_jitter.stl"}) {
    const TriMesh mesh = mesh_of(name);
    const double length = default_weld_length(mesh);
    EXPECT_TRUE(repairs::is_disk(weld(mesh, length).mesh)) << name;
    EXPECT_EQ(find_touching_pieces(mesh, length).joined, 1U) << name;
  }
}

}  // namespace
}  // namespace planish
