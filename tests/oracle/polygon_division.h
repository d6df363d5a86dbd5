#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include <planish/mesh/tri_mesh.h>

#include <gtest/gtest.h>

namespace planish {

/// A face: corners by number, and places of all vertices.
struct TestFace {
  std::vector<Index> corners;
  std::vector<Vec3> positions;
};

/// A face with a vertex at each of the places in the plane, in their order.
inline TestFace flat_face(const std::vector<Vec2>& places) {
  TestFace face;
  for (const Vec2 p : places) {
    face.corners.push_back(static_cast<Index>(face.corners.size()));
    face.positions.push_back({p.x, p.y, 0.0});
  }
  return face;
}

/// A star whose corners are at random distances from its middle.
inline std::vector<Vec2> random_star(std::size_t corners, double least, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  std::vector<Vec2> places;
  for (std::size_t k = 0; k < corners; ++k) {
    const double angle = 2.0 * std::numbers::pi * (static_cast<double>(k) + 0.8 * share(random)) /
                         static_cast<double>(corners);
    const double radius = least + (1.0 - least) * share(random);
    places.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return places;
}

/// The face in another plane of space.
inline TestFace tilted(TestFace face) {
  for (Vec3& p : face.positions) {
    const Vec3 turned = {0.36 * p.x - 0.8 * p.y + 0.48 * p.z, 0.48 * p.x + 0.6 * p.y + 0.64 * p.z,
                         -0.8 * p.x + 0.6 * p.z};
    p = turned + Vec3{700.0, -300.0, 90.0};
  }
  return face;
}

inline TestFace turned_round(TestFace face, std::size_t by, bool back) {
  std::rotate(face.corners.begin(), face.corners.begin() + static_cast<std::ptrdiff_t>(by),
              face.corners.end());
  if (back) std::reverse(face.corners.begin(), face.corners.end());
  return face;
}

/// Twice the area vector of a closed line.
inline Vec3 area_vector(std::span<const Index> corners, std::span<const Vec3> positions) {
  Vec3 area;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    area += cross(positions[corners[k]] - positions[corners[0]],
                  positions[corners[(k + 1) % corners.size()]] - positions[corners[0]]);
  }
  return area;
}

/// The vertices of each triangle in increasing order, and the triangles in order.
inline std::vector<Triangle> sorted_triangles(std::span<const Triangle> triangles) {
  std::vector<Triangle> sorted(triangles.begin(), triangles.end());
  for (Triangle& triangle : sorted)
    std::sort(triangle.begin(), triangle.end());
  std::sort(sorted.begin(), sorted.end());
  return sorted;
}

inline double angle_at(Vec3 corner, Vec3 a, Vec3 b) {
  return std::atan2(norm(cross(a - corner, b - corner)), dot(a - corner, b - corner));
}

/// What is wrong with triangles that are to divide a flat face inside itself: a text for people,
/// empty where nothing is.
inline std::string fault_of_division(const TestFace& face, std::span<const Triangle> triangles) {
  const auto& [corners, positions] = face;
  if (triangles.size() != corners.size() - 2) return "another number of triangles";
  const Vec3 whole = area_vector(corners, positions);
  const Vec3 normal = (1.0 / norm(whole)) * whole;
  // The vertex opposite of each directed side.
  std::map<std::array<Index, 2>, Index> opposite;
  double area = 0.0;
  for (const Triangle& t : triangles) {
    const double part = dot(area_vector(t, positions), normal);
    if (!(part > 0.0)) return "a triangle turns the other way, or has no area";
    area += part;
    for (std::size_t k = 0; k < 3; ++k) {
      const bool fresh = opposite.insert({{t[k], t[(k + 1) % 3]}, t[(k + 2) % 3]}).second;
      if (!fresh) return "two triangles on one side of a line";
    }
  }
  if (std::abs(area - norm(whole)) > 1e-9 * norm(whole)) return "another area";
  std::set<std::array<Index, 2>> sides;
  for (std::size_t k = 0; k < corners.size(); ++k)
    sides.insert({corners[k], corners[(k + 1) % corners.size()]});
  for (const auto& side : sides)
    if (!opposite.contains(side)) return "a side of the face is missing";
  for (const auto& [side, apex] : opposite) {
    const auto [a, b] = side;
    if (sides.contains(side)) continue;
    const auto other = opposite.find({b, a});
    if (other == opposite.end()) return "the outline is another one";
    const double sum = angle_at(positions[apex], positions[a], positions[b]) +
                       angle_at(positions[other->second], positions[a], positions[b]);
    if (sum > std::numbers::pi + 3e-3) return "a diagonal is not that of Delaunay";
  }
  return {};
}

}  // namespace planish
