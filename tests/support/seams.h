#pragma once

// Meshes with border vertices at equal positions, as on the two sides of a seam.

#include <cmath>
#include <cstddef>
#include <numbers>

#include <planish/mesh/tri_mesh.h>

#include "support/meshes.h"

namespace planish::meshes {

/// A vase cut open from top to bottom: the first and the last column of the grid lie at the same
/// positions. `around` + 1 columns, `along` + 1 rows.
inline TriMesh opened_vase(std::size_t around, std::size_t along, double belly = 0.3) {
  TriMesh mesh = flat_grid(around, along);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const std::size_t i = v % (around + 1) % around;
    const double turn =
        2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(around);
    const double height = mesh.positions[v].y / static_cast<double>(along);
    const double radius = 1.0 + belly * std::sin(std::numbers::pi * height);
    mesh.positions[v] = {radius * std::cos(turn), radius * std::sin(turn), 2.0 * height};
  }
  return mesh;
}

/// Curved pages that share their spine, the first column of each: as many border vertices at each
/// place of it as there are pages.
inline TriMesh book(std::size_t pages, std::size_t columns, std::size_t rows) {
  TriMesh book;
  for (std::size_t page = 0; page < pages; ++page) {
    TriMesh mesh = height_field(columns, rows, [&](double x, double y) {
      return 0.05 * x * (static_cast<double>(columns) - x) * (1.0 + 0.02 * y * y);
    });
    const double turn =
        2.0 * std::numbers::pi * static_cast<double>(page) / static_cast<double>(pages);
    const auto shift = static_cast<Index>(book.positions.size());
    for (const Vec3 p : mesh.positions) {
      book.positions.push_back({p.x * std::cos(turn) - p.z * std::sin(turn), p.y,
                                p.x * std::sin(turn) + p.z * std::cos(turn)});
    }
    for (const Triangle& t : mesh.triangles)
      book.triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
  }
  return book;
}

}  // namespace planish::meshes
