#include <algorithm>
#include <limits>
#include <string>

#include <planish/mesh/inspect.h>
#include <planish/mesh/shapes.h>

#include <gtest/gtest.h>

#include "support/meshes.h"

namespace planish {
namespace {

const Problem* find(const Inspection& inspection, ErrorCode code) {
  const auto found = std::find_if(inspection.problems.begin(), inspection.problems.end(),
                                  [code](const Problem& p) { return p.code == code; });
  return found == inspection.problems.end() ? nullptr : &*found;
}

void expect_problem(const TriMesh& mesh, ErrorCode code, std::size_t count, std::size_t first) {
  const Inspection inspection = inspect(mesh);
  const Problem* problem = find(inspection, code);
  ASSERT_NE(problem, nullptr) << to_string(code);
  EXPECT_EQ(problem->count, count) << problem->message;
  EXPECT_EQ(problem->first, first) << problem->message;
  EXPECT_FALSE(problem->message.empty());
}

std::optional<ErrorCode> blocker(const TriMesh& mesh, Purpose purpose) {
  const auto problem = blocking_problem(inspect(mesh), purpose);
  return problem ? std::optional(problem->code) : std::nullopt;
}

TEST(Inspect, FindsNothingWrongWithADisk) {
  for (const Shape& shape : shapes()) {
    const Inspection inspection = inspect(make_shape(shape.name, 300));
    EXPECT_TRUE(inspection.problems.empty()) << shape.name;
    EXPECT_EQ(inspection.topology.components, 1U);
    EXPECT_EQ(inspection.topology.border_loops, 1U);
    EXPECT_EQ(inspection.topology.genus, 0U);
    EXPECT_EQ(inspection.topology.euler_characteristic, 1);
  }
}

TEST(Inspect, CountsVerticesEdgesAndTriangles) {
  const Topology topology = inspect(meshes::flat_grid(3, 2)).topology;
  EXPECT_EQ(topology.vertices, 12U);
  EXPECT_EQ(topology.triangles, 12U);
  EXPECT_EQ(topology.edges, 23U);
  EXPECT_EQ(topology.inner_vertices, 2U);
}

TEST(Inspect, FindsCoordinatesThatAreNotFinite) {
  TriMesh mesh = meshes::flat_grid(3, 3);
  mesh.positions[5].y = std::numeric_limits<double>::quiet_NaN();
  mesh.positions[9].z = std::numeric_limits<double>::infinity();
  expect_problem(mesh, ErrorCode::non_finite_coordinate, 2, 5);
  EXPECT_EQ(blocker(mesh, Purpose::measure), ErrorCode::non_finite_coordinate);
}

TEST(Inspect, FindsIndicesOutOfRange) {
  TriMesh mesh = meshes::flat_grid(2, 2);
  mesh.triangles[3][1] = 9;
  expect_problem(mesh, ErrorCode::index_out_of_range, 1, 3);
  EXPECT_EQ(blocker(mesh, Purpose::measure), ErrorCode::index_out_of_range);
}

TEST(Inspect, FindsAMeshWithoutTriangles) {
  EXPECT_EQ(blocker({{{0, 0, 0}}, {}}, Purpose::measure), ErrorCode::no_triangles);
  EXPECT_EQ(blocker({}, Purpose::measure), ErrorCode::no_triangles);
}

TEST(Inspect, FindsUnreferencedVerticesAndLetsThemBe) {
  TriMesh mesh = meshes::flat_grid(2, 2);
  mesh.positions.push_back({5, 5, 5});
  mesh.positions.push_back({6, 6, 6});
  expect_problem(mesh, ErrorCode::unreferenced_vertex, 2, 9);
  EXPECT_EQ(blocker(mesh, Purpose::unfold), std::nullopt);
  EXPECT_EQ(inspect(mesh).topology.euler_characteristic, 1);
}

TEST(Inspect, FindsARepeatedIndex) {
  TriMesh mesh = meshes::flat_grid(2, 2);
  mesh.triangles.push_back({0, 1, 1});
  expect_problem(mesh, ErrorCode::repeated_index, 1, 8);
  EXPECT_EQ(blocker(mesh, Purpose::measure), ErrorCode::repeated_index);
}

TEST(Inspect, FindsDuplicateTrianglesOfEitherOrientation) {
  TriMesh mesh = meshes::flat_grid(2, 2);
  const Triangle t = mesh.triangles[2];
  mesh.triangles.push_back({t[1], t[2], t[0]});
  expect_problem(mesh, ErrorCode::duplicate_triangle, 1, 8);
  mesh.triangles.back() = {t[1], t[0], t[2]};
  expect_problem(mesh, ErrorCode::duplicate_triangle, 1, 8);
  EXPECT_EQ(blocker(mesh, Purpose::measure), ErrorCode::duplicate_triangle);
}

TEST(Inspect, FindsTwoTrianglesBackToBack) {
  const TriMesh pillow{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 1}}};
  EXPECT_EQ(blocker(pillow, Purpose::measure), ErrorCode::duplicate_triangle);
}

TEST(Inspect, FindsAnEdgeOfThreeTriangles) {
  TriMesh mesh = meshes::flat_grid(2, 2);
  mesh.positions.push_back({1, 1, 1});
  mesh.triangles.push_back({1, 4, 9});
  expect_problem(mesh, ErrorCode::non_manifold_edge, 1, 1);
  EXPECT_EQ(blocker(mesh, Purpose::measure), ErrorCode::non_manifold_edge);
}

TEST(Inspect, FindsAVertexThatJoinsTwoFans) {
  TriMesh mesh = meshes::side_by_side(meshes::flat_grid(2, 2), meshes::flat_grid(2, 2));
  for (Triangle& t : mesh.triangles) {
    for (Index& v : t)
      v = v == 9 ? 8 : v;
  }
  expect_problem(mesh, ErrorCode::non_manifold_vertex, 1, 8);
  EXPECT_EQ(blocker(mesh, Purpose::measure), ErrorCode::non_manifold_vertex);
}

TEST(Inspect, TellsTheTrianglesThatAreTurnedOver) {
  TriMesh mesh = meshes::flat_grid(4, 4);
  std::swap(mesh.triangles[11][0], mesh.triangles[11][1]);
  expect_problem(mesh, ErrorCode::inconsistent_orientation, 1, 11);
  // The fewer are the ones at fault.
  for (Triangle& t : mesh.triangles)
    std::swap(t[0], t[1]);
  expect_problem(mesh, ErrorCode::inconsistent_orientation, 1, 11);
  EXPECT_EQ(blocker(mesh, Purpose::measure), ErrorCode::inconsistent_orientation);
}

TEST(Inspect, TellsAOneSidedSurfaceFromATurnedTriangle) {
  const TriMesh mesh = meshes::moebius(12);
  EXPECT_EQ(blocker(mesh, Purpose::measure), ErrorCode::non_orientable);
  EXPECT_EQ(find(inspect(mesh), ErrorCode::inconsistent_orientation), nullptr);
}

TEST(Inspect, AcceptsAMeshWithAllTrianglesTurnedOver) {
  TriMesh mesh = meshes::flat_grid(3, 3);
  for (Triangle& t : mesh.triangles)
    std::swap(t[0], t[1]);
  EXPECT_TRUE(inspect(mesh).problems.empty());
}

TEST(Inspect, FindsEdgesOfLengthZeroOnce) {
  TriMesh mesh = meshes::flat_grid(3, 3);
  mesh.positions[5] = mesh.positions[6];  // both inside
  expect_problem(mesh, ErrorCode::zero_length_edge, 1, 5);
  EXPECT_EQ(blocker(mesh, Purpose::measure), ErrorCode::zero_length_edge);
}

TEST(Inspect, SaysWhyVerticesFarFromTheOriginAreInOnePlace) {
  for (const double far : {0.0, 100.0, 5e5}) {
    TriMesh collapsed = meshes::flat_grid(3, 3), twice = collapsed;
    collapsed.positions[5] = collapsed.positions[6];
    twice.triangles.push_back(twice.triangles.front());
    for (TriMesh* mesh : {&collapsed, &twice}) {
      for (Vec3& p : mesh->positions)
        p.y -= far;
      const Inspection inspection = inspect(*mesh);
      const Problem* problem = find(
          inspection, mesh == &twice ? ErrorCode::duplicate_triangle : ErrorCode::zero_length_edge);
      ASSERT_NE(problem, nullptr);
      EXPECT_EQ(problem->message.find("move it to the origin") != std::string::npos, far == 5e5)
          << problem->message;
    }
  }
}

TEST(Inspect, DoesNotTakeATinyMeshForOneOfLengthZero) {
  TriMesh mesh = meshes::flat_grid(3, 3);
  for (Vec3& p : mesh.positions)
    p = 1e-200 * p;
  EXPECT_TRUE(inspect(mesh).problems.empty());
  for (Vec3& p : mesh.positions)
    p = 1e200 * (1e200 * p);
  EXPECT_TRUE(inspect(mesh).problems.empty());
}

TEST(Inspect, FindsTrianglesWithoutAreaAndLetsThemBe) {
  TriMesh mesh = meshes::flat_grid(2, 2);
  mesh.positions[4] = {0.5, 0.5, 0.0};
  mesh.positions[0] = {0.0, 0.5, 0.0};
  mesh.positions[1] = {1.0, 0.5, 0.0};
  mesh.positions[3] = {0.0, 1.0, 0.0};
  const Inspection inspection = inspect(mesh);
  ASSERT_NE(find(inspection, ErrorCode::zero_area), nullptr);
  EXPECT_EQ(blocking_problem(inspection, Purpose::unfold), std::nullopt);
}

TEST(Inspect, AClosedSurfaceCanBeMeasuredOnly) {
  const TriMesh mesh = meshes::tetrahedron();
  expect_problem(mesh, ErrorCode::closed_surface, 1, 0);
  EXPECT_EQ(blocker(mesh, Purpose::measure), std::nullopt);
  EXPECT_EQ(blocker(mesh, Purpose::evolve), ErrorCode::closed_surface);
}

TEST(Inspect, ATubeCanBeEvolvedButNotUnfolded) {
  const TriMesh mesh = meshes::tube(6, 3);
  expect_problem(mesh, ErrorCode::several_border_loops, 1, 18);
  EXPECT_EQ(blocker(mesh, Purpose::evolve), std::nullopt);
  EXPECT_EQ(blocker(mesh, Purpose::unfold), ErrorCode::several_border_loops);
}

TEST(Inspect, TwoComponentsCanBeEvolvedButNotUnfolded) {
  const TriMesh mesh = meshes::side_by_side(meshes::flat_grid(2, 2), meshes::flat_grid(3, 3));
  expect_problem(mesh, ErrorCode::several_components, 2, 9);
  EXPECT_EQ(inspect(mesh).topology.border_loops, 2U);
  EXPECT_EQ(blocker(mesh, Purpose::evolve), std::nullopt);
  EXPECT_EQ(blocker(mesh, Purpose::unfold), ErrorCode::several_components);
}

TEST(Inspect, OneBorderLoopDoesNotMakeADisk) {
  TriMesh mesh = meshes::torus(8, 8);
  EXPECT_EQ(inspect(mesh).topology.genus, 1U);
  EXPECT_EQ(inspect(mesh).topology.euler_characteristic, 0);
  mesh.triangles.pop_back();
  expect_problem(mesh, ErrorCode::handles, 1, 0);
  EXPECT_EQ(inspect(mesh).topology.border_loops, 1U);
  EXPECT_EQ(blocker(mesh, Purpose::unfold), ErrorCode::handles);
}

TEST(Inspect, OneTriangleIsADiskWithNothingInside) {
  const TriMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  expect_problem(mesh, ErrorCode::no_inner_vertex, 1, 0);
  EXPECT_EQ(blocker(mesh, Purpose::unfold), std::nullopt);
}

TEST(Inspect, ATriangleSoupIsRefusedForWantOfInnerVertices) {
  TriMesh soup;
  for (const Triangle& t : meshes::flat_grid(2, 2).triangles) {
    const auto first = static_cast<Index>(soup.positions.size());
    for (const Index v : t)
      soup.positions.push_back(meshes::flat_grid(2, 2).positions[v]);
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  EXPECT_EQ(blocker(soup, Purpose::measure), std::nullopt);
  EXPECT_EQ(blocker(soup, Purpose::evolve), ErrorCode::no_inner_vertex);
  EXPECT_EQ(blocker(soup, Purpose::unfold), ErrorCode::no_inner_vertex);
}

TEST(Inspect, RequireThrowsWithCodePlaceAndCount) {
  TriMesh mesh = meshes::flat_grid(2, 2);
  mesh.triangles.push_back({0, 1, 1});
  try {
    require(inspect(mesh), Purpose::measure);
    FAIL() << "accepted a repeated index";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::repeated_index);
    EXPECT_EQ(error.place().first, 8U);
    EXPECT_EQ(error.place().count, 1U);
    EXPECT_NE(std::string(error.what()).find("triangle 8"), std::string::npos);
  }
}

}  // namespace
}  // namespace planish
