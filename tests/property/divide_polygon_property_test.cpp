#include <string>
#include <vector>

#include "mesh/polygon/divide_polygon.h"
#include "oracle/polygon_division.h"
#include "property/property.h"

namespace planish {
namespace {

/// A star, tilted in space, or with its places rounded coarsely, so that corners lie on lines of
/// others; then it may cross itself.
TestFace any_star() {
  const auto corners = static_cast<std::size_t>(*rc::gen::inRange(4, 60));
  const double least = *rc::gen::element(0.05, 0.5, 0.95);
  std::vector<Vec2> places =
      random_star(corners, least, static_cast<unsigned>(*rc::gen::inRange(0, 1'000'000)));
  if (*rc::gen::arbitrary<bool>()) return tilted(flat_face(places));
  for (Vec2& p : places)
    p = {std::round(50.0 * p.x), std::round(50.0 * p.y)};
  return flat_face(places);
}

bool has_sides_without_length(const TestFace& face) {
  for (std::size_t k = 0; k < face.corners.size(); ++k) {
    const Index next = face.corners[(k + 1) % face.corners.size()];
    if (face.positions[face.corners[k]] == face.positions[next]) return true;
  }
  return false;
}

PLANISH_PROPERTY(DividePolygon, FillsStarsWithTheSameTrianglesFromEveryCorner, 3000) {
  const TestFace face = any_star();
  if (has_sides_without_length(face)) return;
  const auto triangles = divide_polygon(face.corners, face.positions);
  if (!triangles) return;
  RC_ASSERT(fault_of_division(face, *triangles) == std::string());
  const auto by =
      static_cast<std::size_t>(*rc::gen::inRange<int>(0, static_cast<int>(face.corners.size())));
  const TestFace turned = turned_round(face, by, *rc::gen::arbitrary<bool>());
  const auto again = divide_polygon(turned.corners, turned.positions);
  RC_ASSERT(again.has_value());
  RC_ASSERT(fault_of_division(turned, *again) == std::string());
  RC_ASSERT(sorted_triangles(*again) == sorted_triangles(*triangles));
}

/// Whatever order corners come in, triangles fill the face or it is refused.
PLANISH_PROPERTY(DividePolygon, FillsOrRefusesAnyCorners, 3000) {
  TestFace face;
  for (int k = *rc::gen::inRange(4, 12); k > 0; --k)
    face.positions.push_back({static_cast<double>(*rc::gen::inRange(0, 7)),
                              static_cast<double>(*rc::gen::inRange(0, 7)), 0.0});
  for (Index k = 0; k < face.positions.size(); ++k)
    face.corners.push_back(
        *rc::gen::inRange<Index>(0, k + 1) < k
            ? k
            : *rc::gen::inRange<Index>(0, static_cast<Index>(face.positions.size())));
  if (has_sides_without_length(face)) return;
  const auto triangles = divide_polygon(face.corners, face.positions);
  if (!triangles) return;
  RC_ASSERT(triangles->size() + 2 == face.corners.size());
  double area = 0.0;
  const Vec3 whole = area_vector(face.corners, face.positions);
  for (const Triangle& t : *triangles) {
    const double part = dot(area_vector(t, face.positions), whole);
    RC_ASSERT(part >= 0.0);
    area += part;
  }
  RC_ASSERT(std::abs(area - dot(whole, whole)) <= 1e-9 * dot(whole, whole));
}

}  // namespace
}  // namespace planish
