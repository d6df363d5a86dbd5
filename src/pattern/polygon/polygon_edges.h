#pragma once

#include <span>
#include <vector>

#include <planish/pattern/piece_outline.h>

namespace planish {

/// From one corner of a polygon to the next.
struct PolygonEdge {
  Vec2 a, b;
};

/// Of all polygons, one after the other, each with its closing edge.
std::vector<PolygonEdge> polygon_edges(std::span<const Polygon> polygons);

}  // namespace planish
