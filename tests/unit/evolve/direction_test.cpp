#include "evolve/direction.h"

#include <algorithm>
#include <cmath>

#include <planish/evolve/evolve.h>
#include <planish/measure/flattenability.h>
#include <planish/mesh/shapes.h>

#include <gtest/gtest.h>

#include "oracle/plain.h"
#include "support/meshes.h"

namespace planish {
namespace {

std::vector<VertexDirection> directions_of(const TriMesh& mesh) {
  return laplacian_directions(Patch(mesh));
}

DirectionCounts counts_of(const TriMesh& mesh) {
  return count_directions(directions_of(mesh));
}

/// Over [-1, 1] x [-1, 1].
template <class Height>
TriMesh surface(std::size_t cells, Height height) {
  TriMesh mesh = meshes::flat_grid(cells, cells);
  const double half = 0.5 * static_cast<double>(cells);
  for (Vec3& p : mesh.positions) {
    p = {p.x / half - 1.0, p.y / half - 1.0, 0.0};
    p.z = height(p.x, p.y);
  }
  return mesh;
}

/// The same in triangles of equal sides: every other row is shifted by half a cell.
template <class Height>
TriMesh hexagonal_surface(std::size_t cells, Height height) {
  TriMesh mesh = surface(cells, height);
  mesh.triangles.clear();
  const auto n = static_cast<Index>(cells + 1);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    Vec3& p = mesh.positions[v];
    const bool shifted = v / n % 2 == 1;
    p = {p.x + (shifted ? 1.0 : 0.0) / static_cast<double>(cells), 0.5 * std::sqrt(3.0) * p.y, 0.0};
    p.z = height(p.x, p.y);
  }
  for (Index row = 0; row + 1 < n; ++row) {
    for (Index column = 0; column + 1 < n; ++column) {
      const Index a = row * n + column, b = a + 1, c = a + n, d = c + 1;
      const bool shifted = row % 2 == 1;
      mesh.triangles.push_back(shifted ? Triangle{a, b, d} : Triangle{a, b, c});
      mesh.triangles.push_back(shifted ? Triangle{a, d, c} : Triangle{b, d, c});
    }
  }
  return mesh;
}

TEST(Direction, SlopeIsThatOfTheRingEnergyAlongTheLaplacian) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    const TriMesh mesh = meshes::rough_grid(7, 6, seed);
    const plain::Patch patch(mesh);
    const auto directions = directions_of(mesh);
    for (Index v = 0; v < directions.size(); ++v) {
      if (!patch.inner[v]) continue;
      const Vec3 L = patch.laplacian(v);
      const double slope = directions[v].slope;
      const double room = 1.0 + std::abs(slope);
      // Central differences.
      constexpr double h = 1e-5;
      const double up = patch.ring_energy(v, mesh.positions[v] + h * L);
      const double down = patch.ring_energy(v, mesh.positions[v] + -h * L);
      EXPECT_NEAR(slope, (up - down) / (2.0 * h), 2e-7 * room) << v;
      // Power series through the formula of every angle.
      double by_series = 0.0;
      for (const plain::Series& d : patch.defects_along(v, L))
        by_series += 2.0 * d.c[0] * d.c[1];
      EXPECT_NEAR(slope, by_series, 1e-12 * room) << v;
      // Eq. 15 to 17 with their errata.
      EXPECT_NEAR(slope, patch.along(v, L, 0.0).slope, 1e-11 * room) << v;
      EXPECT_EQ(directions[v].can_lower, by_series < 0.0) << v;
    }
  }
}

TEST(Direction, DoesNotHangOnSizeOrPlace) {
  const TriMesh mesh = meshes::rough_grid(6, 6, 4);
  const auto directions = directions_of(mesh);
  for (const double factor : {0x1p-600, 0x1p600}) {
    TriMesh other = mesh;
    for (Vec3& p : other.positions)
      p = factor * p;
    const auto scaled = directions_of(other);
    for (std::size_t v = 0; v < scaled.size(); ++v) {
      EXPECT_EQ(scaled[v].slope, directions[v].slope);
      EXPECT_EQ(scaled[v].kind, directions[v].kind);
    }
  }
}

TEST(Direction, ASingleDomeOrCupCanBeLoweredAndASingleSaddleInItsRingCannot) {
  for (std::size_t valence = 3; valence <= 9; ++valence) {
    for (const double height : {0.4, -0.4, 0.01}) {
      const auto tip = directions_of(meshes::fan(valence, height)).front();
      EXPECT_EQ(tip.kind, VertexClass::dome_or_cup);
      EXPECT_TRUE(tip.can_lower) << valence << " " << height;
    }
  }
  // Above the middle of a ruffled ring, yet inside of its hull.
  for (const std::size_t valence : {6, 8, 10}) {
    TriMesh mesh = meshes::ruffled_fan(valence, 0.5);
    mesh.positions[0].z = 0.05;
    const auto middle = directions_of(mesh).front();
    EXPECT_EQ(middle.kind, VertexClass::saddle);
    EXPECT_GE(middle.slope, 0.0);
    EXPECT_FALSE(middle.can_lower) << valence;
  }
}

TEST(Direction, LowersNothingOnAMinimalSaddleOfRegularTriangles) {
  const auto twisted = [](double x, double y) { return 0.4 * x * y; };
  const DirectionCounts hexagonal = counts_of(hexagonal_surface(20, twisted));
  EXPECT_EQ(hexagonal.inner, 361U);
  EXPECT_EQ(hexagonal.saddle, 361U);
  EXPECT_EQ(hexagonal.can_lower, 0U);
  EXPECT_EQ(hexagonal.stuck, 361U);
}

TEST(Direction, LowersTheMiddleOfADomeAndWhatSticksOutOfIt) {
  const DirectionCounts dome =
      counts_of(hexagonal_surface(20, [](double x, double y) { return -0.2 * (x * x + y * y); }));
  EXPECT_EQ(dome.dome_or_cup, 361U);
  EXPECT_GT(dome.can_lower, 0U);
  // Jittered by design: some defects are the largest of their ring.
  const DirectionCounts sample = counts_of(make_shape("dome", 1000));
  EXPECT_GT(sample.can_lower, sample.inner / 10);
}

TEST(Direction, ClassesByTheSignOfTheDefectBeyondTheThreshold) {
  const auto flat = counts_of(meshes::flat_grid(10, 10));
  EXPECT_EQ(flat.flat, 81U);
  EXPECT_EQ(flat.can_lower, 0U) << "rounding is no defect";
  EXPECT_EQ(flat.stuck, 0U);
  EXPECT_EQ(counts_of(surface(20, [](double x, double y) { return x * x + y * y; })).dome_or_cup,
            361U);
  EXPECT_EQ(counts_of(surface(20, [](double x, double y) { return x * x - y * y; })).saddle, 361U);
  TriMesh loose = meshes::flat_grid(3, 3);
  loose.positions.push_back({9.0, 9.0, 9.0});
  const auto directions = directions_of(loose);
  EXPECT_EQ(directions.back().kind, VertexClass::unused);
  EXPECT_EQ(directions.front().kind, VertexClass::border);
  EXPECT_EQ(count_directions(directions).inner, 4U);
}

TEST(Direction, APatchOfFlatVerticesIsFlattenable) {
  for (const std::size_t inner : {1, 50, 100, 1000, 1'000'000}) {
    const double flat = flat_defect(inner);
    EXPECT_GT(flat, 0.0);
    EXPECT_LE(flat, k_flattenable_e_max);
    EXPECT_LE(flat * static_cast<double>(inner), k_flattenable_sum * (1.0 + 1e-15));
  }
  EXPECT_EQ(flat_defect(50), k_flattenable_e_max);
}

TEST(Direction, AgreesWithWhatAControllableSweepFinds) {
  const auto moved_in = [](const TriMesh& mesh) {
    return evolve(Patch(mesh), ControllableLaplacian{}, {.max_sweeps = 1}).history.front().moved;
  };
  EXPECT_EQ(moved_in(hexagonal_surface(20, [](double x, double y) { return 0.4 * x * y; })), 0U);
  EXPECT_EQ(moved_in(meshes::fan(7, 0.3)), 1U);
}

}  // namespace
}  // namespace planish
