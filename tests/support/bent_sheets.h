#pragma once

// One smooth surface at any density: the same formula over equilateral triangles of any size.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include <planish/mesh/tri_mesh.h>

namespace planish::meshes {

/// Equilateral triangles over about the unit square, `cells` of them a row, each vertex where
/// place(u, v) has it. Every second row is shifted by half a cell.
template <class Place>
TriMesh bent_sheet(std::size_t cells, Place place) {
  const double side = 1.0 / static_cast<double>(cells), height = 0.5 * std::sqrt(3.0) * side;
  const auto rows = static_cast<std::size_t>(std::lround(1.0 / height));
  TriMesh mesh;
  for (std::size_t j = 0; j <= rows; ++j) {
    for (std::size_t i = 0; i <= cells; ++i) {
      const double shift = j % 2 == 1 ? 0.5 : 0.0;
      mesh.positions.push_back(
          place(side * (static_cast<double>(i) + shift), height * static_cast<double>(j)));
    }
  }
  const auto at = [cells](std::size_t i, std::size_t j) {
    return static_cast<Index>(j * (cells + 1) + i);
  };
  for (std::size_t j = 0; j < rows; ++j) {
    for (std::size_t i = 0; i < cells; ++i) {
      const Index a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
      if (j % 2 == 0) {
        mesh.triangles.push_back({a, b, d});
        mesh.triangles.push_back({b, c, d});
      } else {
        mesh.triangles.push_back({a, b, c});
        mesh.triangles.push_back({a, c, d});
      }
    }
  }
  return mesh;
}

/// Of radius 1/2, its axis turned by `angle` from the v axis of the sheet.
inline TriMesh bent_cylinder(std::size_t cells, double angle = 0.0) {
  return bent_sheet(cells, [angle](double u, double v) {
    const double across = std::cos(angle) * u + std::sin(angle) * v;
    const double along = std::cos(angle) * v - std::sin(angle) * u;
    return Vec3{0.5 * std::sin(2.0 * across), along, 0.5 * std::cos(2.0 * across)};
  });
}

/// A fifth of a turn of a cone that opens at 30 degrees to its axis, from 1 to 2 off its tip.
inline TriMesh bent_cone(std::size_t cells) {
  return bent_sheet(cells, [](double u, double v) {
    const double from_tip = 1.0 + v, turn = 1.2 * u / 1.5 / 0.5;
    return Vec3{0.5 * from_tip * std::sin(turn), std::sqrt(0.75) * from_tip,
                0.5 * from_tip * std::cos(turn)};
  });
}

/// The tangents of a helix, from 0.6 to 1.6 off it.
inline TriMesh bent_tangents(std::size_t cells) {
  return bent_sheet(cells, [](double u, double v) {
    const double turn = 1.5 * u, along = (0.6 + v) / std::numbers::sqrt2;
    return Vec3{std::cos(turn) - along * std::sin(turn), std::sin(turn) + along * std::cos(turn),
                turn + along};
  });
}

/// A cylinder over a wave.
inline TriMesh bent_wave(std::size_t cells) {
  return bent_sheet(cells, [](double u, double v) { return Vec3{u, v, 0.12 * std::sin(5.0 * u)}; });
}

/// Like the upper of a shoe: an arch around v whose height falls at the instep, and which ends in
/// a round toe at u = 1.
inline TriMesh shoe_upper(std::size_t cells) {
  return bent_sheet(cells, [](double u, double v) {
    const double around = 1.15 * std::numbers::pi * (v / 0.9 - 0.48);
    const double width = 0.34 + 0.06 * std::cos(5.0 * u);
    const double height = 0.55 - 0.28 / (1.0 + std::exp(-12.0 * (u - 0.4)));
    const double to_toe = std::min(std::max(0.0, u - 0.5) / 0.53, 0.95);
    const double toe = std::sqrt(1.0 - to_toe * to_toe);
    return Vec3{1.1 * u, width * toe * std::sin(around), height * toe * std::cos(around)};
  });
}

/// A cap of a sphere of radius 1, through the stereographic map, which keeps angles.
inline TriMesh bent_sphere(std::size_t cells) {
  return bent_sheet(cells, [](double u, double v) {
    const double x = 0.5 * (u - 0.5), y = 0.5 * (v - 0.5), s = 1.0 + x * x + y * y;
    return Vec3{2.0 * x / s, 2.0 * y / s, 2.0 / s - 1.0};
  });
}

/// A smooth fold that turns the sheet by 90 degrees along u = 1/2, most of it within a tenth.
inline TriMesh folded_strip(std::size_t cells) {
  return bent_sheet(cells, [](double u, double v) {
    // The slope turns from -45 to 45 degrees; the arc is summed up finely.
    Vec3 p{0.0, v, 0.0};
    constexpr int steps = 60;
    for (int k = 0; k < steps; ++k) {
      const double s = u * (k + 0.5) / steps;
      const double turn = 0.25 * std::numbers::pi * std::tanh(12.0 * (s - 0.5));
      p += {u / steps * std::cos(turn), 0.0, u / steps * std::sin(turn)};
    }
    return p;
  });
}

/// Waves in all directions, a third of the sheet long.
inline TriMesh crumpled_sheet(std::size_t cells) {
  return bent_sheet(cells, [](double u, double v) {
    constexpr double wave = 6.0 * std::numbers::pi;
    const double z = std::sin(wave * u) * std::cos(0.8 * wave * v) + std::sin(wave * (u + v) / 1.7);
    return Vec3{u, v, 0.03 * z};
  });
}

}  // namespace planish::meshes
