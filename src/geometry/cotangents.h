#pragma once

#include <span>
#include <vector>

#include <planish/core/vec.h>

namespace planish {

/// Of the angle between a and b; large, not infinite, where they are parallel.
double cotangent(Vec3 a, Vec3 b);

/// Whether the last vertex of a ring makes a triangle with the first.
enum class RingEnds { joined, open };

/// The cotangent weights of the edges from p to its ring, in the ring's order.
std::vector<double> cotangent_weights(Vec3 p, std::span<const Vec3> ring,
                                      RingEnds ends = RingEnds::joined);

/// The mixed area of p in its closed ring (Meyer and others 2003): the part of its triangles that
/// is nearest to it, with obtuse triangles cut by halves.
double mixed_area(Vec3 p, std::span<const Vec3> ring);

}  // namespace planish
