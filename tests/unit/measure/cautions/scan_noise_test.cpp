#include <cmath>
#include <string>
#include <vector>

#include <planish/measure/cautions.h>
#include <planish/measure/fairness.h>
#include <planish/measure/flattenability.h>

#include <gtest/gtest.h>

#include "measure/normals.h"
#include "measure/smoothed.h"
#include "support/bent_sheets.h"
#include "support/meshes.h"
#include "unit/measure/cautions/random_diagonals.h"

namespace planish {
namespace {

struct Surface {
  std::string name;
  TriMesh (*make)(std::size_t cells);
};

TriMesh saddle(std::size_t cells) {
  return meshes::bent_sheet(cells, [](double u, double v) {
    const double x = u - 0.5, y = v - 0.5;
    return Vec3{u, v, 0.6 * (x * x - y * y)};
  });
}

TriMesh grid_cylinder(std::size_t cells) {
  const auto size = static_cast<double>(cells);
  TriMesh mesh = meshes::height_field(cells, cells, [size](double x, double) {
    return std::sqrt(size * size - (x - 0.5 * size) * (x - 0.5 * size));
  });
  for (Vec3& p : mesh.positions)
    p = (1.0 / size) * p;
  return mesh;
}

TriMesh cylinder(std::size_t cells) {
  return meshes::bent_cylinder(cells, 0.5);
}

const std::vector<Surface> k_surfaces = {{"cylinder", cylinder},
                                         {"saddle", saddle},
                                         {"sphere", meshes::bent_sphere},
                                         {"cone", meshes::bent_cone},
                                         {"cylinder on a grid", grid_cylinder}};

/// Each vertex moved along its normal, by so many cells as a rule: nearly the normal distribution.
TriMesh with_noise(TriMesh mesh, double size) {
  const auto normals = vertex_normals(mesh.triangles, mesh.positions, 1.0);
  meshes::Random random(7);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    double sum = 0.0;
    for (int k = 0; k < 12; ++k)
      sum += 0.5 * random.number();
    mesh.positions[v] += (size * sum / norm(normals[v])) * normals[v];
  }
  return mesh;
}

double area_of(const TriMesh& mesh) {
  return measure_size(Patch(mesh)).area;
}

TEST(ScanNoise, IsFoundOnSmoothSurfaces) {
  for (const Surface& surface : k_surfaces) {
    for (const std::size_t cells : {16u, 40u}) {
      for (const double size : {0.1, 0.2}) {
        const double edge = 1.0 / static_cast<double>(cells);
        const auto noise = find_scan_noise(Patch(with_noise(surface.make(cells), size * edge)));
        ASSERT_TRUE(noise) << surface.name << ", " << cells << " cells, noise " << size;
        EXPECT_GT(noise->amplitude, 0.7 * size * edge) << surface.name;
        EXPECT_LT(noise->amplitude, 1.3 * size * edge) << surface.name;
      }
    }
  }
}

TEST(ScanNoise, GoesWithTheLengthThatIsProposed) {
  for (const Surface& surface : k_surfaces) {
    const TriMesh clean = surface.make(40);
    const Patch raw(with_noise(clean, 0.1 / 40.0));
    const auto noise = find_scan_noise(raw);
    ASSERT_TRUE(noise) << surface.name;
    const Patch smooth = raw.with_positions(smoothed_positions(raw, noise->wave));
    EXPECT_GT(area_of(raw.mesh()), 1.01 * area_of(clean)) << surface.name;
    EXPECT_NEAR(area_of(smooth.mesh()), area_of(clean), 0.005 * area_of(clean))
        << surface.name << ": but for the noise of the border, which stays";
    EXPECT_FALSE(find_scan_noise(smooth)) << surface.name;
  }
}

TEST(ScanNoise, DoesNotDependOnSize) {
  const TriMesh rough = with_noise(saddle(16), 0.1 / 16.0);
  const auto noise = find_scan_noise(Patch(rough));
  ASSERT_TRUE(noise);
  for (const double size : {1e-200, 1e3, 1e200}) {
    TriMesh mesh = rough;
    for (Vec3& p : mesh.positions)
      p = size * p;
    const auto found = find_scan_noise(Patch(mesh));
    ASSERT_TRUE(found) << size;
    EXPECT_NEAR(found->wave / size, noise->wave, 1e-6 * noise->wave) << size;
    EXPECT_NEAR(found->amplitude / size, noise->amplitude, 1e-6 * noise->amplitude) << size;
  }
}

TEST(ScanNoise, IsNotFoundOnCleanSurfaces) {
  for (const Surface& surface : k_surfaces) {
    for (const std::size_t cells : {6u, 16u, 40u, 80u}) {
      const TriMesh mesh = surface.make(cells);
      EXPECT_FALSE(find_scan_noise(Patch(mesh))) << surface.name << ", " << cells << " cells";
      EXPECT_FALSE(find_scan_noise(Patch(with_noise(mesh, 1e-3 / static_cast<double>(cells)))))
          << surface.name << ": a thousandth of an edge";
    }
  }
  EXPECT_FALSE(find_scan_noise(Patch(meshes::flat_grid(30, 30))));
}

TEST(ScanNoise, IsNotTheFineStructureOfADesign) {
  for (const std::size_t cells : {16u, 40u}) {
    const double edge = 1.0 / static_cast<double>(cells);
    EXPECT_FALSE(find_scan_noise(Patch(meshes::folded_strip(cells))));
    // Pleats along rows of edges, and at an angle to them.
    EXPECT_FALSE(find_scan_noise(Patch(meshes::bent_sheet(cells, [edge](double u, double v) {
      return Vec3{u, v, std::lround(v / (0.5 * std::sqrt(3.0) * edge)) % 2 == 0 ? 0.0 : 0.3 * edge};
    }))));
    for (const double wave : {3.0, 5.0, 8.0}) {
      EXPECT_FALSE(find_scan_noise(Patch(meshes::bent_sheet(
          cells,
          [&](double u, double v) {
            return Vec3{u, v, 0.3 * edge * std::sin(6.28 * (0.8 * u + 0.6 * v) / (wave * edge))};
          }))))
          << wave;
    }
  }
}

TEST(ScanNoise, IsNoTextureThatRepeatsItself) {
  const double turn = std::acos(-1.0);
  for (const std::size_t cells : {24u, 40u}) {
    const double edge = 1.0 / static_cast<double>(cells);
    for (const double height : {0.1, 0.3}) {
      for (const double wave : {2.0, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0, 12.0}) {
        const auto quilt = [&](double u, double v) {
          return height * edge * std::cos(2.0 * turn * u / (wave * edge)) *
                 std::cos(2.0 * turn * v / (wave * edge));
        };
        for (TriMesh grid :
             {meshes::flat_grid(cells, cells), meshes::grid_with_random_diagonals(cells, cells)}) {
          for (Vec3& p : grid.positions)
            p = {edge * p.x, edge * p.y, quilt(edge * p.x, edge * p.y)};
          EXPECT_FALSE(find_scan_noise(Patch(grid))) << "grid, " << wave << ", " << height;
        }
        EXPECT_FALSE(find_scan_noise(Patch(meshes::bent_sheet(cells,
                                                              [&](double u, double v) {
                                                                return Vec3{u, v, quilt(u, v)};
                                                              }))))
            << wave << ", " << height;
        EXPECT_FALSE(find_scan_noise(
            Patch(meshes::bent_sheet(cells,
                                     [&](double u, double v) {
                                       const double r = 0.5 + quilt(u, v);
                                       return Vec3{r * std::cos(2.0 * u), v, r * std::sin(2.0 * u)};
                                     }))))
            << "on a cylinder, " << wave << ", " << height;
      }
    }
    // Every second vertex raised, as the fields of a chess board.
    TriMesh board = meshes::flat_grid(cells, cells);
    for (Vec3& p : board.positions)
      p = {edge * p.x, edge * p.y, std::lround(p.x + p.y) % 2 == 0 ? 0.0 : 0.3 * edge};
    EXPECT_FALSE(find_scan_noise(Patch(board))) << cells;
  }
}

TEST(ScanNoise, LostIsNoFormLost) {
  const TriMesh clean = saddle(30);
  const Patch raw(with_noise(clean, 0.1 / 30.0));
  const Fairness cleaned = measure_fairness(raw, clean.positions);
  EXPECT_TRUE(cleaned.keeps_form());
  EXPECT_LT(*cleaned.bending_lost, 0.3);
  // The plane under it has lost all.
  std::vector<Vec3> pressed = clean.positions;
  for (Vec3& p : pressed)
    p.z = 0.01 * p.z;
  EXPECT_FALSE(measure_fairness(raw, pressed).keeps_form());
  EXPECT_GT(*measure_fairness(raw, pressed).bending_lost, 0.8);
}

}  // namespace
}  // namespace planish
