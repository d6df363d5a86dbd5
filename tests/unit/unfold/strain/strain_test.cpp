#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include <planish/unfold/strain.h>

#include <gtest/gtest.h>

#include "support/meshes.h"
#include "unfold/strain/strain_of_edges.h"

namespace planish {
namespace {

std::vector<Vec2> mapped(const TriMesh& mesh, double xx, double xy, double yx, double yy) {
  std::vector<Vec2> flat;
  for (const Vec3 p : mesh.positions)
    flat.push_back({xx * p.x + xy * p.y, yx * p.x + yy * p.y});
  return flat;
}

TEST(EdgeStrain, IsZeroForTheSameLengths) {
  const TriMesh mesh = meshes::flat_grid(4, 3);
  const EdgeStrain strain = edge_strain(Patch(mesh), mapped(mesh, 1, 0, 0, 1));
  EXPECT_EQ(strain.max, 0.0);
  EXPECT_EQ(strain.rms, 0.0);
}

TEST(EdgeStrain, HasStretchAndCompressionOnTheShareOfAllEdges) {
  std::vector<StrainOfEdge> edges;
  for (int k = 0; k < 500; ++k)
    edges.push_back({0.001 * ((k * 37) % 101 - 60), 1.0 + (k * 13) % 7, {}});
  const EdgeStrain strain = figures_of(edges);
  for (const Criterion kind :
       {Criterion::p99_strain, Criterion::p99_stretch, Criterion::p99_compression}) {
    std::vector<StrainOfEdge> parts = edges;
    for (StrainOfEdge& edge : parts)
      edge.strain = part_of(edge.strain, kind);
    EXPECT_EQ(figure_of(strain, kind), strain_at_share(parts, 0.99));
    EXPECT_GT(figure_of(strain, kind), 0.0);
  }
}

TEST(EdgeStrain, WeighsEdgesByTheAreaOfTheirTriangles) {
  // 2 x 1 cells: 2 + 2 edges along x, 3 along y, 2 diagonals. Only x is stretched, by 10 %. Edges
  // inside have two triangles, those of the border one: 4 along x and 2 diagonals count 4 + 4.
  const TriMesh mesh = meshes::flat_grid(2, 1);
  const EdgeStrain strain = edge_strain(Patch(mesh), mapped(mesh, 1.1, 0, 0, 1));
  const double diagonal = std::sqrt(2.21 / 2.0) - 1.0;
  EXPECT_NEAR(strain.max, 0.1, 1e-15);
  EXPECT_NEAR(strain.rms, std::sqrt((4 * 0.01 + 4 * diagonal * diagonal) / 12.0), 1e-15);
  EXPECT_NEAR(strain.p99, 0.1, 1e-15);
}

/// All edges with the areas of their triangles, by looking at every triangle.
struct Weighed {
  double strain = 0.0, area = 0.0;
};
std::vector<Weighed> plainly_weighed(const TriMesh& mesh, const std::vector<Vec2>& flat) {
  std::map<std::pair<Index, Index>, Weighed> edges;
  for (const Triangle& t : mesh.triangles) {
    const Vec3 a = mesh.positions[t[0]], b = mesh.positions[t[1]], c = mesh.positions[t[2]];
    const double area = 0.5 * norm(cross(b - a, c - a));
    for (int k = 0; k < 3; ++k) {
      const auto [v, w] = std::minmax(t[k], t[(k + 1) % 3]);
      Weighed& edge = edges[{v, w}];
      edge.strain = norm(flat[w] - flat[v]) / norm(mesh.positions[w] - mesh.positions[v]) - 1.0;
      edge.area += area;
    }
  }
  std::vector<Weighed> list;
  for (const auto& [ends, edge] : edges)
    list.push_back(edge);
  return list;
}

TEST(EdgeStrain, IsWhatLookingAtEveryTriangleGives) {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const TriMesh mesh = meshes::rough_grid(9, 7, seed, 0.3, 0.6);
    const auto flat = mapped(mesh, 1.05, 0.1, -0.2, 0.9);
    auto edges = plainly_weighed(mesh, flat);
    double squares = 0.0, area = 0.0;
    for (const Weighed& edge : edges) {
      squares += edge.area * edge.strain * edge.strain;
      area += edge.area;
    }
    std::sort(edges.begin(), edges.end(), [](const Weighed& a, const Weighed& b) {
      return std::abs(a.strain) > std::abs(b.strain);
    });
    double beyond = 0.0;
    std::size_t k = 0;
    while (beyond + edges[k].area <= 0.01 * area)
      beyond += edges[k++].area;
    const EdgeStrain strain = edge_strain(Patch(mesh), flat);
    EXPECT_NEAR(strain.rms, std::sqrt(squares / area), 1e-13);
    EXPECT_NEAR(strain.max, std::abs(edges.front().strain), 1e-13);
    EXPECT_NEAR(strain.p99, std::abs(edges[k].strain), 1e-13);
    EXPECT_LT(strain.p99, strain.max);
  }
}

TEST(EdgeStrain, DoesNotDependOnWhereTheMeshIsFine) {
  // Laid flat by exp(), which stretches all directions alike, from 0 on the left to 22 % on the
  // right, where the mesh has nine times the triangles then.
  TriMesh mesh = meshes::flat_grid(20, 10);
  const auto rms = [&] {
    std::vector<Vec2> flat;
    for (const Vec3 p : mesh.positions) {
      const double radius = 100.0 * std::exp(0.01 * p.x);
      flat.push_back({radius * std::cos(0.01 * p.y), radius * std::sin(0.01 * p.y)});
    }
    return edge_strain(Patch(mesh), flat).rms;
  };
  const double before = rms();
  for (int round = 0; round < 2; ++round) {
    const std::size_t count = mesh.triangles.size();
    for (std::size_t i = 0; i < count; ++i) {
      const Triangle t = mesh.triangles[i];
      const Vec3 middle =
          (1.0 / 3.0) * (mesh.positions[t[0]] + mesh.positions[t[1]] + mesh.positions[t[2]]);
      if (middle.x < 10.0) continue;
      const auto m = static_cast<Index>(mesh.positions.size());
      mesh.positions.push_back(middle);
      mesh.triangles[i] = {t[0], t[1], m};
      mesh.triangles.push_back({t[1], t[2], m});
      mesh.triangles.push_back({t[2], t[0], m});
    }
  }
  EXPECT_NEAR(rms(), before, 0.01 * before);
}

TEST(EdgeStrain, P99LeavesOutTheWorstHundredthOfTheArea) {
  TriMesh mesh = meshes::flat_grid(20, 20);
  const Patch patch(mesh);
  auto flat = mapped(mesh, 1, 0, 0, 1);
  flat[0] = {-0.5, 0.0};  // three of 1,240 edges
  const EdgeStrain strain = edge_strain(patch, flat);
  EXPECT_GT(strain.max, 0.2);
  EXPECT_EQ(strain.worst_edge[0], 0U) << "the vertex that was moved";
  EXPECT_EQ(strain.p99, 0.0);
}

TEST(PrincipalStretches, AreTheSingularValuesOfTheMap) {
  const TriMesh mesh = meshes::flat_grid(3, 3);
  for (const PrincipalStretch& s : principal_stretches(mesh, mapped(mesh, 0, -1.2, 0.9, 0))) {
    EXPECT_NEAR(s.max, 1.2, 1e-14);
    EXPECT_NEAR(s.min, 0.9, 1e-14);
  }
  for (const PrincipalStretch& s : principal_stretches(mesh, mapped(mesh, 1, 0, 0, -1))) {
    EXPECT_NEAR(s.min, -1.0, 1e-14) << "a mirrored triangle is flipped";
  }
}

TEST(PrincipalStretches, TakeATriangleWithoutAreaAsNotStretched) {
  const TriMesh mesh{{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}}};
  const auto stretch = principal_stretches(mesh, mapped(mesh, 1, 0, 0, 1));
  EXPECT_EQ(stretch[0].max, 1.0);
  EXPECT_EQ(stretch[0].min, 1.0);
}

TEST(SignedStrains, ShowTheLargerOfBothWithItsSign) {
  const std::vector<PrincipalStretch> stretches{{1.05, 0.99}, {1.01, 0.9}, {1.0, 1.0}};
  const auto strains = signed_strains(stretches);
  EXPECT_NEAR(strains[0], 0.05, 1e-15);
  EXPECT_NEAR(strains[1], -0.1, 1e-15);
  EXPECT_EQ(strains[2], 0.0);
}

}  // namespace
}  // namespace planish
