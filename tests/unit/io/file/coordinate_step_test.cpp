#include <cstdio>
#include <string>
#include <vector>

#include <planish/io/mesh_format.h>

#include <gtest/gtest.h>

#include "unit/io/io_testing.h"

namespace planish {
namespace {

/// A strip of triangles at a distance from the origin.
TriMesh strip(double far) {
  TriMesh mesh;
  for (Index k = 0; k < 40; ++k) {
    mesh.positions.push_back({far + 1.2345678901 * k, 0.987654321 * (k % 2), 0.1 * k * k / 7.0});
    if (k > 1) mesh.triangles.push_back({k - 2, k - 1, k});
  }
  return mesh;
}

/// As C prints its coordinates.
std::string obj_of(const TriMesh& mesh, const char* format) {
  std::string text;
  for (const Vec3 p : mesh.positions) {
    text += 'v';
    for (const double c : {p.x, p.y, p.z}) {
      char word[64];
      std::snprintf(word, sizeof word, format, c);
      text += ' ';
      text += word;
    }
    text += '\n';
  }
  for (const Triangle& t : mesh.triangles) {
    text += 'f';
    for (const Index v : t)
      text += ' ' + std::to_string(v + 1);
    text += '\n';
  }
  return text;
}

double step_of(const std::string& bytes, MeshFormat format = MeshFormat::obj) {
  return parse_mesh(bytes, format, "mesh").coordinate_step;
}

TEST(CoordinateStep, IsTheSpacingOfFloatsWhereTheyAreLargest) {
  EXPECT_EQ(step_of(format_mesh(strip(4e5), MeshFormat::stl), MeshFormat::stl), 0.03125);
  EXPECT_EQ(step_of(format_mesh(strip(0.0), MeshFormat::stl), MeshFormat::stl), 0x1p-18);
  EXPECT_EQ(step_of(format_mesh(strip(4e5), MeshFormat::ply), MeshFormat::ply), 0.0);  // doubles
}

TEST(CoordinateStep, OfFloatsIsFoundInFilesWithMoreDigits) {
  const TriMesh floats =
      parse_mesh(format_mesh(strip(4e5), MeshFormat::stl), MeshFormat::stl, "mesh").mesh;
  for (const MeshFormat format : {MeshFormat::obj, MeshFormat::ply, MeshFormat::off})
    EXPECT_EQ(step_of(format_mesh(floats, format), format), 0.03125) << to_string(format);
}

TEST(CoordinateStep, IsThatOfTheDecimals) {
  EXPECT_EQ(step_of(obj_of(strip(0.0), "%.3f")), 0.001);
  EXPECT_EQ(step_of(obj_of(strip(100.0), "%.6f")), 1e-6);
  EXPECT_EQ(step_of(obj_of(strip(100.0), "%.6e")), 1e-4);
}

TEST(CoordinateStep, IsThatOfTheLargestNumbersInTheGeneralFormat) {
  EXPECT_EQ(step_of(obj_of(strip(4e5), "%g")), 1.0);
  EXPECT_EQ(step_of(obj_of(strip(1e6), "%g")), 10.0);
  EXPECT_EQ(step_of(obj_of(strip(100.0), "%g")), 1e-3);
}

TEST(CoordinateStep, IsNotKnownOfWholeDigitsAndOfDesigns) {
  EXPECT_EQ(step_of(obj_of(strip(4e5), "%.17g")), 0.0);
  EXPECT_EQ(step_of(obj_of(square(), "%g")), 0.0);
  TriMesh grid = strip(0.0);
  for (std::size_t k = 0; k < grid.positions.size(); ++k)
    grid.positions[k] = {12.5 * static_cast<double>(k), 3.0 * static_cast<double>(k % 2), 0.0};
  EXPECT_EQ(step_of(obj_of(grid, "%g")), 0.0);
}

}  // namespace
}  // namespace planish
