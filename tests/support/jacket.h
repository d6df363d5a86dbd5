#pragma once

// A jacket of five panels on a body by formula, each meshed by itself: vertices of neighbours lie
// on the same curves at other places.

#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <planish/mesh/tri_mesh.h>

#include "mesh/split.h"
#include "support/meshes.h"

namespace planish::meshes {

/// Millimetres. The front of the body is z = depth(x, y), its back -depth(x, y); both meet at the
/// side seams and on the shoulders.
class Jacket {
 public:
  static std::vector<NamedPatch> panels(double shift = 0.0) {
    const Grain right{17, 48, 20, 9, 0.3}, left{19, 45, 21, 10, -0.25}, rear{38, 52, 24, 11, 0.2};
    std::vector<NamedPatch> panels;
    panels.push_back({"front_right", half(right, 1.0), {}});
    panels.push_back({"front_left", half(left, -1.0), {}});
    panels.push_back({"back", back(rear), {}});
    panels.push_back({"sleeve_right", sleeve(1.0, 44, 40), {}});
    panels.push_back({"sleeve_left", sleeve(-1.0, 46, 37), {}});
    for (NamedPatch& panel : panels) {
      for (Vec3& p : panel.mesh.positions)
        p += {shift, 2.0 * shift, -shift};
    }
    return panels;
  }

  /// Names of what is sewn to what, those with lower numbers first.
  static std::vector<std::pair<std::size_t, std::size_t>> seams() {
    return {{0, 1}, {0, 2}, {0, 2}, {0, 3}, {1, 2}, {1, 2}, {1, 4}, {2, 3}, {2, 4}, {3, 3}, {4, 4}};
  }

 private:
  /// How a panel is meshed: its columns and rows, the row of the armhole's lower end, the column
  /// where the neck ends, and how uneven the spacing is, -1 to 1.
  struct Grain {
    std::size_t columns, rows, underarm, neck;
    double uneven;
  };

  static double wave(double u) { return std::sin(2.0 * std::numbers::pi * u); }
  static double uneven(double u, double a) { return u + a * wave(u) / (2.0 * std::numbers::pi); }

  static double depth(Vec2 p) {
    const double side = (200.0 - 0.05 * p.y - p.x) / 200.0;
    const double shoulder = (640.0 - 0.4 * (p.x - 70.0) - p.y) / 600.0;
    const auto part = [](double s) { return s > 1e-12 ? s / (s + 0.25) : 0.0; };
    return 220.0 * part(side) * part(shoulder);
  }

  // Curves of the right half in the plane, by shares from 0 to 1.
  static Vec2 side(double u) { return {200.0 - 20.0 * u, 400.0 * u}; }
  static Vec2 armhole(double u) {
    return {180.0 - 30.0 * u - 30.0 * std::sin(std::numbers::pi * u), 400.0 + 208.0 * u};
  }
  static Vec2 shoulder(double u) { return {150.0 - 80.0 * u, 608.0 + 32.0 * u}; }
  static Vec2 neck(double u) {  // from the shoulder to the middle
    return {70.0 * std::cos(0.5 * std::numbers::pi * u),
            640.0 - 60.0 * std::sin(0.5 * std::numbers::pi * u)};
  }

  static Vec2 right_edge(std::size_t j, const Grain& grain) {
    const double a = grain.uneven;
    if (j <= grain.underarm) return side(uneven(share(j, grain.underarm), a));
    return armhole(uneven(share(j - grain.underarm, grain.rows - grain.underarm), a));
  }

  /// From the middle (0) to the shoulder's end.
  static Vec2 upper_edge(std::size_t i, std::size_t columns, const Grain& grain) {
    const double a = grain.uneven;
    if (i <= grain.neck) return neck(1.0 - uneven(share(i, grain.neck), a));
    return shoulder(1.0 - uneven(share(i - grain.neck, columns - grain.neck), a));
  }

  static double share(std::size_t k, std::size_t n) {
    return static_cast<double>(k) / static_cast<double>(n);
  }
  static Vec2 mirrored(Vec2 p) { return {-p.x, p.y}; }

  /// Fills a grid between four edges.
  template <class Left, class Right, class Lower, class Upper>
  static std::vector<Vec2> filled(std::size_t columns, std::size_t rows, Left left, Right right,
                                  Lower lower, Upper upper) {
    std::vector<Vec2> grid;
    for (std::size_t j = 0; j <= rows; ++j) {
      for (std::size_t i = 0; i <= columns; ++i) {
        const double s = share(i, columns), t = share(j, rows);
        if (i == 0 || i == columns || j == 0 || j == rows) {
          grid.push_back(i == 0 ? left(j) : i == columns ? right(j) : j == 0 ? lower(i) : upper(i));
          continue;
        }
        const Vec2 corners = (1.0 - s) * (1.0 - t) * left(0) + s * (1.0 - t) * right(0) +
                             (1.0 - s) * t * left(rows) + s * t * right(rows);
        grid.push_back((1.0 - s) * left(j) + s * right(j) + (1.0 - t) * lower(i) + t * upper(i) -
                       corners);
      }
    }
    return grid;
  }

  static TriMesh lifted(const std::vector<Vec2>& grid, std::size_t columns, std::size_t rows,
                        double sign) {
    TriMesh mesh = flat_grid(columns, rows);
    for (std::size_t v = 0; v < grid.size(); ++v) {
      const Vec2 p = grid[v];
      mesh.positions[v] = {p.x, p.y, sign * depth({std::abs(p.x), p.y})};
    }
    return mesh;
  }

  static TriMesh half(const Grain& grain, double sign) {
    const Vec2 low = {0.0, 0.0}, high = neck(1.0);
    const std::vector<Vec2> grid = filled(
        grain.columns, grain.rows,
        [&](std::size_t j) {
          return low + uneven(share(j, grain.rows), grain.uneven) * (high - low);
        },
        [&](std::size_t j) { return right_edge(j, grain); },
        [&](std::size_t i) { return share(i, grain.columns) * side(0.0); },
        [&](std::size_t i) { return upper_edge(i, grain.columns, grain); });
    TriMesh mesh = lifted(grid, grain.columns, grain.rows, 1.0);
    return sign > 0.0 ? mesh : mirror(std::move(mesh));
  }

  static TriMesh back(const Grain& grain) {
    const std::size_t half = grain.columns / 2;
    const auto on_half = [&](std::size_t i, auto curve) {
      return i >= half ? curve(i - half) : mirrored(curve(half - i));
    };
    const std::vector<Vec2> grid = filled(
        grain.columns, grain.rows, [&](std::size_t j) { return mirrored(right_edge(j, grain)); },
        [&](std::size_t j) { return right_edge(j, grain); },
        [&](std::size_t i) {
          return on_half(i, [&](std::size_t k) { return share(k, half) * side(0.0); });
        },
        [&](std::size_t i) {
          return on_half(i, [&](std::size_t k) { return upper_edge(k, half, grain); });
        });
    TriMesh mesh = lifted(grid, grain.columns, grain.rows, -1.0);
    for (Triangle& t : mesh.triangles)
      std::swap(t[1], t[2]);
    return mesh;
  }

  /// Once round the armhole, from the underarm over the front to the shoulder and back.
  static Vec3 cap(double u) {
    const double front = u <= 0.5 ? 1.0 : -1.0;
    const Vec2 p = armhole(front > 0.0 ? 2.0 * u : 2.0 - 2.0 * u);
    return {p.x, p.y, front * depth(p)};
  }

  static Vec3 wrist(double u) {
    const double turn = 2.0 * std::numbers::pi * u;
    return {520.0 + 10.0 * std::cos(turn), 180.0 - 45.0 * std::cos(turn), 45.0 * std::sin(turn)};
  }

  /// Open along the line from the underarm to the wrist, whose two sides have other vertices.
  static TriMesh sleeve(double sign, std::size_t around, std::size_t along) {
    TriMesh mesh = flat_grid(around, along);
    for (std::size_t j = 0; j <= along; ++j) {
      for (std::size_t i = 0; i <= around; ++i) {
        const double u = i == around ? 1.0 : uneven(share(i, around), 0.4);
        const double r = uneven(share(j, along), 0.7 * share(i, around) - 0.3);
        mesh.positions[j * (around + 1) + i] = (1.0 - r) * cap(u) + r * wrist(u);
      }
    }
    return sign > 0.0 ? mesh : mirror(std::move(mesh));
  }

  static TriMesh mirror(TriMesh mesh) {
    for (Vec3& p : mesh.positions)
      p.x = 0.0 - p.x;
    for (Triangle& t : mesh.triangles)
      std::swap(t[1], t[2]);
    return mesh;
  }
};

}  // namespace planish::meshes
