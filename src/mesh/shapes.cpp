#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <planish/core/error.h>
#include <planish/core/range.h>
#include <planish/mesh/shapes.h>

#include "core/math.h"
#include "core/split_mix.h"

namespace planish {

namespace {

constexpr double k_pi = std::numbers::pi;

/// A number in [-0.5, 0.5) that depends on nothing but its arguments (splitmix64).
double noise(std::uint64_t salt, std::size_t i, std::size_t j) {
  std::uint64_t z = salt * SplitMix::k_step + i * 0xbf58476d1ce4e5b9ULL + j;
  for (int round = 0; round < 2; ++round)
    z = SplitMix::mixed(z + SplitMix::k_step);
  return SplitMix::as_share(z) - 0.5;
}

/// A grid of columns x rows vertices, column by column.
struct Grid {
  std::size_t columns, rows;

  Index at(std::size_t i, std::size_t j) const { return static_cast<Index>(i * rows + j); }
};

/// About `vertices` vertices in cells that are square on a patch `aspect` times as wide as high.
Grid grid_of(std::size_t vertices, double aspect) {
  const double n = static_cast<double>(vertices);
  const double rows = std::max(3.0, std::round(std::sqrt(n / aspect)));
  return {static_cast<std::size_t>(std::max(3.0, std::round(n / rows))),
          static_cast<std::size_t>(rows)};
}

/// Step k of n along a side, in [0, 1], jittered but at the ends.
double jittered(std::size_t k, std::size_t n, double jitter) {
  const double shift = k == 0 || k + 1 == n ? 0.0 : 0.5 * jitter;
  return (static_cast<double>(k) + shift) / static_cast<double>(n - 1);
}

/// Two triangles per cell, split along the shorter diagonal; outside is where columns x rows
/// points.
std::vector<Triangle> triangulate(const Grid& grid, const std::vector<Vec3>& positions) {
  std::vector<Triangle> triangles;
  triangles.reserve(2 * (grid.columns - 1) * (grid.rows - 1));
  for (std::size_t i = 0; i + 1 < grid.columns; ++i) {
    for (std::size_t j = 0; j + 1 < grid.rows; ++j) {
      const Index a = grid.at(i, j), b = grid.at(i + 1, j);
      const Index c = grid.at(i + 1, j + 1), d = grid.at(i, j + 1);
      if (norm(positions[c] - positions[a]) <= norm(positions[d] - positions[b])) {
        triangles.push_back({a, b, c});
        triangles.push_back({a, c, d});
      } else {
        triangles.push_back({a, b, d});
        triangles.push_back({b, c, d});
      }
    }
  }
  return triangles;
}

/// The surface point(s, t) over the unit square, jittered in both directions.
template <class Point>
TriMesh grid_patch(const Grid& grid, std::uint64_t salt, Point point) {
  TriMesh mesh;
  mesh.positions.reserve(grid.columns * grid.rows);
  for (std::size_t i = 0; i < grid.columns; ++i) {
    for (std::size_t j = 0; j < grid.rows; ++j) {
      mesh.positions.push_back(point(jittered(i, grid.columns, noise(salt, i, j)),
                                     jittered(j, grid.rows, noise(salt + 1, i, j))));
    }
  }
  mesh.triangles = triangulate(grid, mesh.positions);
  return mesh;
}

/// A surface made of plane strips between straight rulings: ruling(i)(t) walks along ruling i. Two
/// neighbouring rulings lie in one plane, so the mesh unfolds exactly however its vertices are
/// strewn along them.
template <class Ruling>
TriMesh ruled_patch(const Grid& grid, std::uint64_t salt, Ruling ruling) {
  TriMesh mesh;
  mesh.positions.reserve(grid.columns * grid.rows);
  for (std::size_t i = 0; i < grid.columns; ++i) {
    const auto along = ruling(i);
    for (std::size_t j = 0; j < grid.rows; ++j) {
      mesh.positions.push_back(along(jittered(j, grid.rows, noise(salt, i, j))));
    }
  }
  mesh.triangles = triangulate(grid, mesh.positions);
  return mesh;
}

/// A vertex out of place, as scans have them: a third of an edge off the surface.
void pinch_some_vertices(const Grid& grid, double edge, TriMesh& mesh) {
  constexpr std::size_t pinches = 12;
  for (std::size_t k = 0; k < pinches; ++k) {
    const double s = 0.5 + 0.9 * noise(91, k, 0), t = 0.5 + 0.9 * noise(92, k, 0);
    const auto i = static_cast<std::size_t>(s * static_cast<double>(grid.columns - 1));
    const auto j = static_cast<std::size_t>(t * static_cast<double>(grid.rows - 1));
    if (i == 0 || j == 0 || i + 1 >= grid.columns || j + 1 >= grid.rows) continue;
    mesh.positions[grid.at(i, j)].z += (k % 2 == 0 ? 0.33 : -0.33) * edge;
  }
}

/// The front of a wetsuit, say: a tapered tube sector with a few bulges and dents.
TriMesh panel(std::size_t vertices) {
  constexpr double width = 420.0, height = 560.0;
  const Grid grid = grid_of(vertices, width / height);
  struct Bump {
    double s, t, radius, rise;
  };
  static constexpr std::array<Bump, 6> bumps{{{0.30, 0.70, 70.0, 14.0},
                                              {0.70, 0.68, 70.0, 14.0},
                                              {0.50, 0.30, 90.0, 10.0},
                                              {0.18, 0.22, 45.0, -5.0},
                                              {0.82, 0.25, 45.0, -5.0},
                                              {0.52, 0.52, 40.0, -4.0}}};
  TriMesh mesh = grid_patch(grid, 1, [](double s, double t) {
    const double radius = 190.0 + 50.0 * t;
    const double angle = (s - 0.5) * width / 200.0;
    double rise = 0.0;
    for (const Bump& bump : bumps) {
      const double dx = (s - bump.s) * width / bump.radius;
      const double dy = (t - bump.t) * height / bump.radius;
      rise += bump.rise * math::exp(-dx * dx - dy * dy);
    }
    return Vec3{(radius + rise) * math::sin(angle), height * t, (radius + rise) * math::cos(angle)};
  });
  pinch_some_vertices(grid, height / static_cast<double>(grid.rows - 1), mesh);
  return mesh;
}

TriMesh saddle(std::size_t vertices) {
  return grid_patch(grid_of(vertices, 1.0), 3, [](double s, double t) {
    const double u = 2.0 * s - 1.0, v = 2.0 * t - 1.0;
    return Vec3{150.0 * u, 150.0 * v, 45.0 * (u * u - v * v)};
  });
}

/// A spherical cap in rings of 6, 12, 18, ... vertices around its top.
TriMesh dome(std::size_t vertices) {
  constexpr double radius = 200.0, opening = 70.0 * k_pi / 180.0;
  // 1 + 3 k (k + 1) vertices in k rings
  const auto rings = static_cast<std::size_t>(std::max(
      2.0, std::round(std::sqrt((static_cast<double>(vertices) - 1.0) / 3.0 + 0.25) - 0.5)));
  TriMesh mesh;
  mesh.positions.push_back({0.0, 0.0, radius});
  for (std::size_t k = 1; k <= rings; ++k) {
    for (std::size_t i = 0; i < 6 * k; ++i) {
      const double shift = k == rings ? 0.0 : 0.5 * noise(5, k, i);
      const double polar = opening * (static_cast<double>(k) + shift) / static_cast<double>(rings);
      const double around =
          2.0 * k_pi * (static_cast<double>(i) + 0.5 * noise(6, k, i)) / static_cast<double>(6 * k);
      mesh.positions.push_back({radius * math::sin(polar) * math::cos(around),
                                radius * math::sin(polar) * math::sin(around),
                                radius * math::cos(polar)});
    }
  }
  const auto at = [](std::size_t k, std::size_t i) {
    return static_cast<Index>(k == 0 ? 0 : 1 + 3 * k * (k - 1) + i % (6 * k));
  };
  for (std::size_t k = 1; k <= rings; ++k) {
    for (std::size_t sector = 0; sector < 6; ++sector) {
      for (std::size_t i = 0; i < k; ++i) {
        const std::size_t outer = sector * k + i, inner = sector * (k - 1) + i;
        mesh.triangles.push_back({at(k, outer), at(k, outer + 1), at(k - 1, inner)});
        if (i + 1 == k) continue;
        mesh.triangles.push_back({at(k, outer + 1), at(k - 1, inner + 1), at(k - 1, inner)});
      }
    }
  }
  return mesh;
}

TriMesh cylinder(std::size_t vertices) {
  constexpr double radius = 150.0, arc = 150.0 * k_pi / 180.0, length = 400.0;
  const Grid grid = grid_of(vertices, radius * arc / length);
  return ruled_patch(grid, 7, [&](std::size_t i) {
    const double angle = (jittered(i, grid.columns, noise(8, i, 0)) - 0.5) * arc;
    const Vec3 foot{radius * math::sin(angle), 0.0, radius * math::cos(angle)};
    return [foot](double t) { return foot + Vec3{0.0, length * t, 0.0}; };
  });
}

TriMesh cone(std::size_t vertices) {
  constexpr double slope = 30.0 * k_pi / 180.0, arc = 200.0 * k_pi / 180.0;
  constexpr double from = 100.0, to = 450.0;  // along the rulings, from the apex
  const Grid grid = grid_of(vertices, 0.5 * (from + to) * 0.5 * arc / (to - from));
  return ruled_patch(grid, 9, [&](std::size_t i) {
    const double angle = jittered(i, grid.columns, noise(10, i, 0)) * arc;
    const Vec3 ruling{math::sin(slope) * math::cos(angle), math::sin(slope) * math::sin(angle),
                      -math::cos(slope)};
    return [ruling](double t) { return (from + (to - from) * t) * ruling; };
  });
}

/// The tangents of a polyline on a helix: two successive ones meet, so each strip is plane.
TriMesh tangent(std::size_t vertices) {
  constexpr double radius = 150.0, pitch = 100.0, turn = 1.6;
  constexpr double from = 60.0, to = 300.0;  // along the tangents, from the helix
  const Grid grid = grid_of(vertices, 1.2);
  const auto helix = [&](std::size_t i) {
    const double shift = 0.5 * noise(12, i, 0);
    const double angle =
        turn * (static_cast<double>(i) + shift) / static_cast<double>(grid.columns);
    return Vec3{radius * math::cos(angle), radius * math::sin(angle), pitch * angle};
  };
  return ruled_patch(grid, 11, [&](std::size_t i) {
    const Vec3 begin = helix(i), end = helix(i + 1);
    const Vec3 ruling = (1.0 / norm(end - begin)) * (end - begin);
    return [end, ruling](double t) { return end + (from + (to - from) * t) * ruling; };
  });
}

struct Recipe {
  Shape shape;
  TriMesh (*make)(std::size_t);
};

constexpr std::array<Recipe, 6> k_recipes{
    {{{"panel", "front of a wetsuit: nearly flattenable, with bumps, dents and stray vertices",
       false},
      panel},
     {{"saddle", "hyperbolic paraboloid: curvature below zero everywhere", false}, saddle},
     {{"dome", "spherical cap: curvature above zero everywhere", false}, dome},
     {{"cylinder", "sector of a tube, flattenable", true}, cylinder},
     {{"cone", "sector of a cone, flattenable", true}, cone},
     {{"tangent", "tangents of a helix, flattenable", true}, tangent}}};

constexpr auto k_shapes = [] {
  std::array<Shape, k_recipes.size()> shapes{};
  for (std::size_t i = 0; i < shapes.size(); ++i)
    shapes[i] = k_recipes[i].shape;
  return shapes;
}();

}  // namespace

std::span<const Shape> shapes() {
  return k_shapes;
}

TriMesh make_shape(std::string_view name, std::size_t vertices) {
  check_range("vertices", static_cast<double>(vertices), Range{100.0, 1e7});
  std::string known;
  for (const Recipe& recipe : k_recipes) {
    if (recipe.shape.name == name) return recipe.make(vertices);
    known += (known.empty() ? "" : ", ") + std::string(recipe.shape.name);
  }
  throw Error(ErrorCode::unknown_name,
              "there is no sample called \"" + std::string(name) + "\"; known are " + known);
}

}  // namespace planish
