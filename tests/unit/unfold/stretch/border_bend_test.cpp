#include "unfold/stretch/border_bend.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/math.h"
#include "support/meshes.h"

namespace planish {
namespace {

struct FlatGrid {
  TriMesh mesh = meshes::rough_grid(5, 4, 7, 0.2, 0.3);
  Disk disk = make_disk(Patch(mesh));
  BorderLengths lengths{border_lengths(mesh, disk)};
  std::vector<Vec2> flat = std::vector<Vec2>(disk.vertex_count);

  FlatGrid() {
    for (std::size_t v = 0; v < flat.size(); ++v) {
      const Vec3 p = mesh.positions[disk.vertex_of[v]];
      flat[v] = {p.x, p.y};
    }
  }
  /// Every place a little elsewhere.
  std::vector<Vec2> shaken(unsigned seed) const {
    meshes::Random random(seed);
    std::vector<Vec2> places = flat;
    for (Vec2& p : places)
      p = p + 0.1 * Vec2{random.number(), random.number()};
    return places;
  }
};

TEST(BorderBend, CostsNothingWhereTheBorderTurnsAsItWould) {
  const FlatGrid grid;
  const BorderBend bend(grid.disk, grid.lengths, grid.flat);
  EXPECT_EQ(bend.turns().size(), grid.disk.border.size());
  EXPECT_EQ(bend.energy(grid.flat), 0.0);
  std::vector<Vec2> turned = grid.flat;
  const double c = math::cos(2.0), s = math::sin(2.0);
  for (Vec2& p : turned)
    p = 3.0 * Vec2{c * p.x - s * p.y, s * p.x + c * p.y};
  EXPECT_NEAR(bend.energy(turned), 0.0, 1e-25);
  EXPECT_GT(bend.energy(grid.shaken(1)), 1e-6);
}

TEST(BorderBend, HasTheDerivativesOfItsEnergy) {
  const FlatGrid grid;
  const BorderBend bend(grid.disk, grid.lengths, grid.flat);
  std::vector<Vec2> flat = grid.shaken(2);
  std::vector<double> gradient(2 * flat.size(), 0.0);
  for (const BorderBend::Turn& turn : bend.turns()) {
    const auto own = BorderBend::derivatives(turn, flat);
    for (std::size_t i = 0; i < 6; ++i)
      gradient[2 * turn.vertices[i / 2] + i % 2] += own.gradient[i];
  }
  constexpr double h = 1e-6;
  for (std::size_t i = 0; i < gradient.size(); ++i) {
    double& coordinate = i % 2 == 0 ? flat[i / 2].x : flat[i / 2].y;
    const double at = coordinate;
    coordinate = at + h;
    const double above = bend.energy(flat);
    coordinate = at - h;
    const double below = bend.energy(flat);
    coordinate = at;
    EXPECT_NEAR((above - below) / (2.0 * h), gradient[i], 1e-8) << i;
  }
}

/// Twice the weight times the squared slope of the angle, along any direction.
TEST(BorderBend, HasACurvatureThatIsNeverNegative) {
  const FlatGrid grid;
  const BorderBend bend(grid.disk, grid.lengths, grid.flat);
  const std::vector<Vec2> flat = grid.shaken(3);
  meshes::Random random(4);
  for (const BorderBend::Turn& turn : bend.turns()) {
    const auto own = BorderBend::derivatives(turn, flat);
    std::array<double, 6> move;
    for (double& x : move)
      x = random.number();
    double curvature = 0.0, slope = 0.0;
    for (std::size_t i = 0; i < 6; ++i) {
      slope += own.gradient[i] * move[i];
      for (std::size_t j = 0; j < 6; ++j)
        curvature += move[i] * own.hessian[i][j] * move[j];
    }
    // The slope is twice the weight times the change of the angle times the slope of the angle.
    const double value = BorderBend::energy_of(turn, flat);
    EXPECT_NEAR(curvature * value, 0.5 * slope * slope, 1e-12 * std::abs(curvature * value));
    EXPECT_GE(curvature, 0.0);
  }
}

TEST(BorderBend, IsOfTheEndsOfEdgesThatKeepTheirLength) {
  FlatGrid grid;
  const std::size_t n = grid.disk.border.size();
  grid.lengths.is_free.assign(n, 1);
  EXPECT_TRUE(BorderBend(grid.disk, grid.lengths, grid.flat).turns().empty());
  grid.lengths.is_free[4] = 0;
  const auto turns = BorderBend(grid.disk, grid.lengths, grid.flat).turns();
  ASSERT_EQ(turns.size(), 2U);
  EXPECT_EQ(turns[0].vertices[1], grid.disk.border[4]);
  EXPECT_EQ(turns[1].vertices[1], grid.disk.border[5]);
}

TEST(BorderBend, LeavesOutEdgesThatAreMuchShorterThanOthers) {
  FlatGrid grid;
  grid.lengths.of_edges[6] *= 1e-3;
  EXPECT_EQ(BorderBend(grid.disk, grid.lengths, grid.flat).turns().size(),
            grid.disk.border.size() - 2);
}

}  // namespace
}  // namespace planish
