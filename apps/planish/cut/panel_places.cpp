#include "cut/panel_places.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace planish::cli {

namespace {

constexpr double k_along = 0.8;   // of the mean normal's length, along the axis
constexpr double k_facing = 0.3;  // of its length in all: 1 where a piece is flat, 0 all around
constexpr double k_aside = 0.05;  // of the box of the product, from its middle

struct Axis {
  double Vec3::*coordinate;
  const char *low, *high;
};
constexpr std::array<Axis, 3> k_axes = {
    {{&Vec3::x, "xmin", "xmax"}, {&Vec3::y, "ymin", "ymax"}, {&Vec3::z, "zmin", "zmax"}}};

/// The least and the greatest coordinate of a product along an axis.
struct Extent {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
};

std::array<Extent, 3> box_of(std::span<const NamedPatch> pieces) {
  std::array<Extent, 3> box;
  for (const NamedPatch& piece : pieces) {
    for (const Vec3& p : piece.mesh.positions) {
      for (std::size_t k = 0; k < 3; ++k) {
        box[k].low = std::min(box[k].low, p.*k_axes[k].coordinate);
        box[k].high = std::max(box[k].high, p.*k_axes[k].coordinate);
      }
    }
  }
  return box;
}

/// @param box of the product
std::string place_of(const TriMesh& piece, const std::array<Extent, 3>& box) {
  const double scale = unit_scale(piece);
  Vec3 normal{}, centre{};
  double area = 0.0;
  for (const Triangle& t : piece.triangles) {
    const Vec3 a = scale * piece.positions[t[0]], b = scale * piece.positions[t[1]],
               c = scale * piece.positions[t[2]];
    const Vec3 twice = cross(b - a, c - a);
    const double part = norm(twice);
    normal += twice;
    centre += (part / 3.0) * (a + b + c);
    area += part;
  }
  if (!(area > 0.0)) return {};
  for (std::size_t k = 0; k < 3; ++k) {
    const Axis& axis = k_axes[k];
    const double extent = scale * box[k].high - scale * box[k].low;
    const double middle = 0.5 * (scale * box[k].high + scale * box[k].low);
    const double along = normal.*axis.coordinate;
    const bool is_facing = std::abs(along) >= std::max(k_along * norm(normal), k_facing * area);
    const double aside = centre.*axis.coordinate / area - middle;
    if (!is_facing || !(extent > 0.0)) continue;
    if (along > 0.0 && aside >= k_aside * extent) return axis.high;
    if (along < 0.0 && aside <= -k_aside * extent) return axis.low;
  }
  return {};
}

}  // namespace

std::vector<std::string> places_of_pieces(std::span<const NamedPatch> pieces) {
  const std::array<Extent, 3> box = box_of(pieces);
  std::vector<std::string> places;
  places.reserve(pieces.size());
  for (const NamedPatch& piece : pieces)
    places.push_back(place_of(piece.mesh, box));
  std::vector<std::string> unique = places;
  for (std::string& place : unique) {
    if (std::count(places.begin(), places.end(), place) > 1) place.clear();
  }
  return unique;
}

std::vector<NamedPatch> pieces_by_place(const TriMesh& cut, const std::string& name) {
  std::vector<NamedPatch> pieces = split(cut, name);
  if (pieces.size() < 2) return pieces;
  const std::vector<std::string> places = places_of_pieces(pieces);
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    if (!places[p].empty()) pieces[p].name = name + "-" + places[p];
  }
  return pieces;
}

bool is_place(std::string_view word) {
  return std::any_of(k_axes.begin(), k_axes.end(),
                     [&](const Axis& axis) { return word == axis.low || word == axis.high; });
}

}  // namespace planish::cli
