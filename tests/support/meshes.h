#pragma once

// Small meshes for tests, each with one property that its name tells.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <numbers>
#include <set>
#include <utility>
#include <vector>

#include <planish/mesh/tri_mesh.h>

namespace planish::meshes {

/// (columns + 1) x (rows + 1) vertices over unit cells, z = height(x, y).
template <class Height>
TriMesh height_field(std::size_t columns, std::size_t rows, Height height) {
  TriMesh mesh;
  for (std::size_t j = 0; j <= rows; ++j) {
    for (std::size_t i = 0; i <= columns; ++i) {
      const auto x = static_cast<double>(i), y = static_cast<double>(j);
      mesh.positions.push_back({x, y, height(x, y)});
    }
  }
  const auto at = [columns](std::size_t i, std::size_t j) {
    return static_cast<Index>(j * (columns + 1) + i);
  };
  for (std::size_t j = 0; j < rows; ++j) {
    for (std::size_t i = 0; i < columns; ++i) {
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return mesh;
}

inline TriMesh flat_grid(std::size_t columns, std::size_t rows) {
  return height_field(columns, rows, [](double, double) { return 0.0; });
}

/// The same numbers for the same seed on every platform.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed * 2 + 1) {}
  /// In [-1, 1).
  double number() {
    state_ = state_ * 6364136223846793005ULL + 1442695040888963407ULL;
    return static_cast<double>(state_ >> 11) * 0x1p-52 - 1.0;
  }

 private:
  std::uint64_t state_;
};

/// Anywhere in a cube of sides twice this size around the origin.
inline Vec3 random_point(Random& random, double size) {
  return {size * random.number(), size * random.number(), size * random.number()};
}

/// A grid with every vertex moved at random: by `in_plane` cells in x and y, by `height` in z.
inline TriMesh rough_grid(std::size_t columns, std::size_t rows, std::uint64_t seed,
                          double in_plane = 0.25, double height = 0.3) {
  Random random(seed);
  TriMesh mesh = flat_grid(columns, rows);
  for (Vec3& p : mesh.positions) {
    p += {in_plane * random.number(), in_plane * random.number(), height * random.number()};
  }
  return mesh;
}

/// One inner vertex, number 0, at the given height over a regular ring of radius 1.
inline TriMesh fan(std::size_t valence, double height = 0.0) {
  TriMesh mesh;
  mesh.positions.push_back({0.0, 0.0, height});
  for (std::size_t j = 0; j < valence; ++j) {
    const double angle =
        2.0 * std::numbers::pi * static_cast<double>(j) / static_cast<double>(valence);
    mesh.positions.push_back({std::cos(angle), std::sin(angle), 0.0});
    mesh.triangles.push_back(
        {0, static_cast<Index>(1 + j), static_cast<Index>(1 + (j + 1) % valence)});
  }
  return mesh;
}

/// A fan whose ring is folded up and down: the angle sum of vertex 0 is above 2 pi.
inline TriMesh ruffled_fan(std::size_t valence, double amplitude) {
  TriMesh mesh = fan(valence);
  for (std::size_t j = 1; j <= valence; ++j) {
    mesh.positions[j].z = j % 2 == 0 ? amplitude : -amplitude;
  }
  return mesh;
}

/// An open tube: two border loops.
inline TriMesh tube(std::size_t around, std::size_t along) {
  TriMesh mesh;
  for (std::size_t j = 0; j <= along; ++j) {
    for (std::size_t i = 0; i < around; ++i) {
      const double angle =
          2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(around);
      mesh.positions.push_back({std::cos(angle), std::sin(angle), static_cast<double>(j)});
    }
  }
  const auto at = [around](std::size_t i, std::size_t j) {
    return static_cast<Index>(j * around + i % around);
  };
  for (std::size_t j = 0; j < along; ++j) {
    for (std::size_t i = 0; i < around; ++i) {
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return mesh;
}

/// A closed torus; without its last triangles, one with a hole.
inline TriMesh torus(std::size_t around, std::size_t along) {
  TriMesh mesh = tube(around, along);
  const std::size_t last = around * along;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const double turn = 2.0 * std::numbers::pi * mesh.positions[v].z / static_cast<double>(along);
    const double r = 3.0 + mesh.positions[v].x, z = mesh.positions[v].y;
    mesh.positions[v] = {r * std::cos(turn), r * std::sin(turn), z};
  }
  for (Triangle& t : mesh.triangles) {
    for (Index& v : t)
      v = v >= last ? static_cast<Index>(v - last) : v;
  }
  mesh.positions.resize(last);
  return mesh;
}

/// The sum of the areas of all triangles.
inline double area(const TriMesh& mesh) {
  double area = 0.0;
  for (const Triangle& t : mesh.triangles) {
    const Vec3 a = mesh.positions[t[0]];
    area += 0.5 * norm(cross(mesh.positions[t[1]] - a, mesh.positions[t[2]] - a));
  }
  return area;
}

/// A plate of 12 by 6 with two square holes.
inline TriMesh plate_with_two_holes() {
  TriMesh plate = flat_grid(12, 6);
  std::erase_if(plate.triangles, [&](const Triangle& t) {
    const Vec3 middle =
        (1.0 / 3.0) * (plate.positions[t[0]] + plate.positions[t[1]] + plate.positions[t[2]]);
    return std::abs(middle.y - 3.0) < 1.0 &&
           (std::abs(middle.x - 3.0) < 1.0 || std::abs(middle.x - 9.0) < 1.0);
  });
  return plate;
}

inline TriMesh tetrahedron() {
  return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
          {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
}

/// A strip with half a twist.
inline TriMesh moebius(std::size_t around) {
  TriMesh mesh;
  for (std::size_t i = 0; i < around; ++i) {
    const double angle =
        2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(around);
    for (const double w : {-0.3, 0.0, 0.3}) {
      const double r = 1.0 + w * std::cos(angle / 2.0);
      mesh.positions.push_back(
          {r * std::cos(angle), r * std::sin(angle), w * std::sin(angle / 2.0)});
    }
  }
  const auto at = [around](std::size_t i, std::size_t k) {
    return static_cast<Index>(i < around ? 3 * i + k : 3 * (i - around) + (2 - k));
  };
  for (std::size_t i = 0; i < around; ++i) {
    for (std::size_t k = 0; k < 2; ++k) {
      mesh.triangles.push_back({at(i, k), at(i + 1, k), at(i + 1, k + 1)});
      mesh.triangles.push_back({at(i, k), at(i + 1, k + 1), at(i, k + 1)});
    }
  }
  return mesh;
}

/// Both meshes in one, the second moved aside.
inline TriMesh side_by_side(TriMesh a, const TriMesh& b) {
  const auto shift = static_cast<Index>(a.positions.size());
  for (const Vec3 p : b.positions)
    a.positions.push_back(p + Vec3{1000.0, 0.0, 0.0});
  for (const Triangle& t : b.triangles) {
    a.triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
  }
  return a;
}

/// Every triangle with vertices of its own.
inline TriMesh soup_of(const TriMesh& mesh) {
  TriMesh soup;
  for (const Triangle& t : mesh.triangles) {
    const auto first = static_cast<Index>(soup.positions.size());
    for (const Index v : t)
      soup.positions.push_back(mesh.positions[v]);
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  return soup;
}

using Place = std::function<Vec3(double, double)>;

/// Three triangles at one edge, which is no manifold.
inline TriMesh fins() {
  return {{{50, 0, 0}, {51, 0, 0}, {50, 1, 0}, {50, 0, 1}, {50, -1, 0}},
          {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}};
}

/// A grid of unit cells without some of them, each vertex where `place` puts it.
inline TriMesh perforated(std::size_t columns, std::size_t rows,
                          const std::set<std::size_t>& without, const Place& place) {
  TriMesh mesh = flat_grid(columns, rows);
  std::vector<Triangle> kept;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (!without.contains(t / 2)) kept.push_back(mesh.triangles[t]);
  }
  mesh.triangles = kept;
  for (Vec3& p : mesh.positions)
    p = place(p.x, p.y);
  return mesh;
}

/// Cells of such a grid: blocks of `size` by `size`, `across` by `along` of them, spread evenly.
inline std::set<std::size_t> blocks(std::size_t columns, std::size_t rows, std::size_t across,
                                    std::size_t along, std::size_t size) {
  std::set<std::size_t> cells;
  for (std::size_t i = 0; i < across; ++i) {
    for (std::size_t j = 0; j < along; ++j) {
      const std::size_t x = (2 * i + 1) * columns / (2 * across) - size / 2;
      const std::size_t y = (2 * j + 1) * rows / (2 * along) - size / 2;
      for (std::size_t a = 0; a < size; ++a) {
        for (std::size_t b = 0; b < size; ++b)
          cells.insert((y + b) * columns + x + a);
      }
    }
  }
  return cells;
}

inline Vec3 on_plane(double x, double y) {
  return {x, y, 0.0};
}

inline Vec3 on_cylinder(double x, double y) {
  constexpr double radius = 12.0;
  return {radius * std::cos(x / radius), radius * std::sin(x / radius), y};
}

inline Vec3 on_cone(double x, double y) {
  const double angle = x / 10.0, from_apex = 15.0 + y;
  return {0.6 * from_apex * std::cos(angle), 0.6 * from_apex * std::sin(angle), 0.8 * from_apex};
}

/// Each triangle as four, the middles of sides as vertices; the four are where the one was.
inline TriMesh finer(const TriMesh& mesh) {
  TriMesh result{mesh.positions, {}};
  std::map<std::pair<Index, Index>, Index> middles;
  const auto middle = [&](Index a, Index b) {
    const auto [found, is_new] = middles.try_emplace({std::min(a, b), std::max(a, b)},
                                                     static_cast<Index>(result.positions.size()));
    if (is_new) result.positions.push_back(0.5 * (mesh.positions[a] + mesh.positions[b]));
    return found->second;
  };
  for (const Triangle& t : mesh.triangles) {
    const Index a = middle(t[0], t[1]), b = middle(t[1], t[2]), c = middle(t[2], t[0]);
    result.triangles.insert(result.triangles.end(),
                            {{t[0], a, c}, {a, t[1], b}, {c, b, t[2]}, {a, b, c}});
  }
  return result;
}

inline TriMesh finer(TriMesh mesh, int times) {
  for (int i = 0; i < times; ++i)
    mesh = finer(mesh);
  return mesh;
}

}  // namespace planish::meshes
