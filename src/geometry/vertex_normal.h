#pragma once

#include <cstddef>

#include <planish/core/vec.h>

namespace planish {

/// The unit normal at p in its closed ring of `count` neighbours, its triangles weighing as their
/// areas; zero where they cancel.
/// @param position_of neighbour number -> Vec3
template <class PositionOf>
Vec3 vertex_normal(Vec3 p, std::size_t count, const PositionOf& position_of) {
  Vec3 normal;
  for (std::size_t j = 0; j < count; ++j)
    normal += cross(position_of(j) - p, position_of(j + 1 < count ? j + 1 : 0) - p);
  const double length = norm(normal);
  return length > 0.0 ? (1.0 / length) * normal : Vec3{};
}

}  // namespace planish
