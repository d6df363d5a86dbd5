#pragma once

// Arbitrary meshes, and arbitrary patches that may be worked on, from bytes.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include <planish/mesh/inspect.h>
#include <planish/mesh/tri_mesh.h>

#include "fuzz/bytes.h"

namespace planish::fuzz {

/// Vertex numbers of a grid of at most 8 x 8 cells, cut by either diagonal.
inline TriMesh grid_from(Bytes& bytes) {
  const std::size_t columns = bytes.whole(1, 8), rows = bytes.whole(1, 8);
  TriMesh mesh;
  for (std::size_t j = 0; j <= rows; ++j) {
    for (std::size_t i = 0; i <= columns; ++i)
      mesh.positions.push_back({static_cast<double>(i), static_cast<double>(j), 0.0});
  }
  for (std::size_t j = 0; j < rows; ++j) {
    for (std::size_t i = 0; i < columns; ++i) {
      const auto a = static_cast<Index>(j * (columns + 1) + i), b = a + 1;
      const auto d = static_cast<Index>(a + columns + 1), c = d + 1;
      if ((i + j) % 3 == 0) {
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

/// A vertex with a ring around it.
inline TriMesh fan_from(Bytes& bytes) {
  const std::size_t valence = bytes.whole(3, 20);
  TriMesh mesh{{{0.0, 0.0, 0.0}}, {}};
  for (std::size_t j = 0; j < valence; ++j) {
    const double angle = 6.283185307179586 * static_cast<double>(j) / static_cast<double>(valence);
    mesh.positions.push_back({std::cos(angle), std::sin(angle), 0.0});
    mesh.triangles.push_back(
        {0, static_cast<Index>(1 + j), static_cast<Index>(1 + (j + 1) % valence)});
  }
  return mesh;
}

/// The corner of t that follows the edge from a to b, if that is an edge of it.
inline std::optional<Index> third_corner(const Triangle& t, Index a, Index b) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (t[k] == a && t[(k + 1) % 3] == b) return t[(k + 2) % 3];
  }
  return std::nullopt;
}

/// Turns the edge between two triangles; what comes of it may be no manifold.
inline void flip_edge(TriMesh& mesh, std::size_t triangle, std::size_t corner) {
  Triangle& one = mesh.triangles[triangle];
  const Index a = one[corner], b = one[(corner + 1) % 3], c = one[(corner + 2) % 3];
  for (Triangle& other : mesh.triangles) {
    const auto d = third_corner(other, b, a);
    if (!d || *d == c) continue;
    one = {c, a, *d};
    other = {c, *d, b};
    return;
  }
}

/// Moves all vertices: a little, onto few values, or anywhere at all.
inline void move_vertices(TriMesh& mesh, Bytes& bytes) {
  const std::size_t kind = bytes.whole(0, 7);
  const double size =
      kind == 5 ? std::ldexp(1.0, static_cast<int>(bytes.whole(0, 600)) - 300) : 1.0;
  for (Vec3& p : mesh.positions) {
    if (kind < 4) {
      p += {0.4 * bytes.fraction(), 0.4 * bytes.fraction(), 2.0 * bytes.fraction()};
    } else if (kind == 4) {
      const std::size_t where = bytes.byte();
      p += {static_cast<double>(where % 3), static_cast<double>(where / 3 % 3),
            static_cast<double>(where / 9 % 3)};
    } else if (kind == 5) {
      p = size * (p + Vec3{bytes.fraction(), bytes.fraction(), bytes.fraction()});
    } else if (kind == 6) {
      p = {bytes.any_double(), bytes.any_double(), bytes.any_double()};
    } else {
      p.z += 0.25 * bytes.fraction();
    }
  }
  if (kind == 7) {
    Vec3& p = mesh.positions[bytes.whole(0, mesh.positions.size() - 1)];
    p = {bytes.any_double(), bytes.any_double(), bytes.any_double()};
  }
}

/// A mesh of one sheet, which may be broken in most ways.
inline TriMesh mesh_from(Bytes& bytes) {
  const bool is_fan = bytes.whole(0, 3) == 0;
  TriMesh mesh = is_fan ? fan_from(bytes) : grid_from(bytes);
  for (std::size_t flips = bytes.whole(0, 7); flips > 0; --flips) {
    const std::size_t triangle = bytes.whole(0, mesh.triangles.size() - 1);
    flip_edge(mesh, triangle, bytes.whole(0, 2));
  }
  for (std::size_t holes = bytes.whole(0, 15); holes > 12 && mesh.triangles.size() > 1; --holes) {
    const std::size_t at = bytes.whole(0, mesh.triangles.size() - 1);
    mesh.triangles.erase(mesh.triangles.begin() + static_cast<std::ptrdiff_t>(at));
  }
  move_vertices(mesh, bytes);
  return mesh;
}

/// A patch that is fit for the purpose, or nothing.
inline std::optional<TriMesh> patch_from(Bytes& bytes, Purpose purpose) {
  TriMesh mesh = mesh_from(bytes);
  if (blocking_problem(planish::inspect(mesh), purpose)) return std::nullopt;
  return mesh;
}

/// @param share of the size of the patch
inline bool has_edges_below(double share, const TriMesh& mesh) {
  const double shortest = share * bounding_box_diagonal(mesh);
  for (const Triangle& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 edge = mesh.positions[t[k]] - mesh.positions[t[(k + 1) % 3]];
      if (std::hypot(edge.x, edge.y, edge.z) < shortest) return true;
    }
  }
  return false;
}

}  // namespace planish::fuzz
