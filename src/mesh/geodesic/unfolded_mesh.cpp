#include "mesh/geodesic/unfolded_mesh.h"

#include <algorithm>
#include <cmath>

#include <planish/mesh/inspect.h>

#include "geometry/angle_between.h"
#include "mesh/carry/place_on_triangle.h"

namespace planish {

namespace {

/// What is so near to an end of its edge is the vertex there.
constexpr double k_at_vertex = 1e-12;

constexpr double k_sum_error = 1e-9;  // of given shares

std::vector<Vec3> scaled_positions(const Patch& patch) {
  require(patch.inspection(), Purpose::measure);
  std::vector<Vec3> positions = patch.positions();
  for (Vec3& p : positions)
    p = patch.unit_scale() * p;
  return positions;
}

}  // namespace

UnfoldedMesh::UnfoldedMesh(const Patch& patch)
    : scale_(patch.unit_scale()), positions_(scaled_positions(patch)), half_edges_(patch.mesh()) {
  sides_.reserve(half_edges_.size());
  for (Index h = 0; h < half_edges_.size(); ++h) {
    const Vec3 from = position(half_edges_.from(h));
    const Vec3 side = position(half_edges_.to(h)) - from;
    const Vec3 to_apex = position(half_edges_.apex(h)) - from;
    const double length = norm(side);
    sides_.push_back({length, {dot(side, to_apex) / length, norm(cross(side, to_apex)) / length}});
  }
}

double UnfoldedMesh::corner_angle(Index h) const {
  return angle_between(Vec2{1.0, 0.0}, apex(h));
}

Vec2 UnfoldedMesh::in_next(Index h, Vec2 p) const {
  // Where h begins. The frame of the next side itself tells most exactly where that is.
  const Vec2 back = apex(HalfEdges::next(h));
  const Vec2 w = (1.0 / norm(back)) * back;
  return (length(h) - p.x) * w - p.y * Vec2{-w.y, w.x};
}

Vec2 UnfoldedMesh::in_previous(Index h, Vec2 p) const {
  const Vec2 w = (1.0 / norm(apex(h))) * apex(h);
  return {length(HalfEdges::previous(h)) - dot(p, w), -cross(w, p)};
}

Vec2 UnfoldedMesh::in_frame(Index h, const SurfacePoint& place) const {
  Vec2 p;
  for (std::size_t k = 0; k < 3; ++k) {
    if (place.corners[k] == half_edges_.to(h)) p = p + place.shares[k] * Vec2{length(h), 0.0};
    if (place.corners[k] == half_edges_.apex(h)) p = p + place.shares[k] * apex(h);
  }
  return p;
}

Index UnfoldedMesh::corner(Index triangle, Index v) const {
  for (Index h = 3 * triangle; h < 3 * triangle + 3; ++h) {
    if (half_edges_.from(h) == v) return h;
  }
  return none;
}

double UnfoldedMesh::angle_to(Index h) const {
  double angle = 0.0;
  bool is_before = true;
  half_edges_.for_each_corner(half_edges_.from(h), [&](Index g) {
    is_before = is_before && g != h;
    if (is_before) angle += corner_angle(g);
  });
  return angle;
}

double UnfoldedMesh::angle_around(Index v) const {
  double angle = 0.0;
  half_edges_.for_each_corner(v, [&](Index h) { angle += corner_angle(h); });
  return angle;
}

Index UnfoldedMesh::triangle_of(const Triangle& corners) const {
  const auto [a, b, c] = corners;
  Index triangle = none;
  if (a >= positions_.size() || !half_edges_.is_used(a) || a == b || b == c || c == a)
    return triangle;
  half_edges_.for_each_corner(a, [&, b = b, c = c](Index h) {
    if (corner(h / 3, b) != none && corner(h / 3, c) != none) triangle = h / 3;
  });
  return triangle;
}

Index UnfoldedMesh::vertex_of(const SurfacePoint& place) {
  const auto& s = place.shares;
  if (std::count(s.begin(), s.end(), 0.0) != 2) return none;
  return place.corners[static_cast<std::size_t>(std::max_element(s.begin(), s.end()) - s.begin())];
}

SurfacePoint UnfoldedMesh::checked(const SurfacePoint& place) const {
  const auto& s = place.shares;
  const Index triangle = triangle_of(place.corners);
  if (triangle == none || !(*std::min_element(s.begin(), s.end()) >= -k_least_share) ||
      !(std::abs(s[0] + s[1] + s[2] - 1.0) <= k_sum_error)) {
    throw Error(ErrorCode::option_out_of_range,
                "a place has corners that are no triangle of the mesh, or shares that are negative "
                "or do not sum to 1: take a place of this mesh");
  }
  SurfacePoint result = between(triangle, place, place, 0.0);
  result.shares = cleared(result.shares);
  return result;
}

std::vector<Index> UnfoldedMesh::triangles_at(const SurfacePoint& place) const {
  const auto k = static_cast<std::size_t>(
      std::max_element(place.shares.begin(), place.shares.end()) - place.shares.begin());
  std::vector<Index> triangles;
  half_edges_.for_each_corner(place.corners[k], [&](Index h) {
    if (is_on(h / 3, place)) triangles.push_back(h / 3);
  });
  return triangles;
}

bool UnfoldedMesh::is_on(Index triangle, const SurfacePoint& place) const {
  for (std::size_t k = 0; k < 3; ++k) {
    if (place.shares[k] > 0.0 && corner(triangle, place.corners[k]) == none) return false;
  }
  return true;
}

bool UnfoldedMesh::is_on_edge(Index h, const SurfacePoint& place) const {
  for (std::size_t k = 0; k < 3; ++k) {
    const Index v = place.corners[k];
    if (place.shares[k] > 0.0 && v != half_edges_.from(h) && v != half_edges_.to(h)) return false;
  }
  return true;
}

SurfacePoint UnfoldedMesh::between(Index triangle, const SurfacePoint& a, const SurfacePoint& b,
                                   double t) const {
  SurfacePoint result;
  for (std::size_t k = 0; k < 3; ++k) {
    result.corners[k] = half_edges_.from(3 * triangle + static_cast<Index>(k));
    result.shares[k] = 0.0;
    for (std::size_t j = 0; j < 3; ++j) {
      if (a.corners[j] == result.corners[k]) result.shares[k] += (1.0 - t) * a.shares[j];
      if (b.corners[j] == result.corners[k]) result.shares[k] += t * b.shares[j];
    }
  }
  return result;
}

SurfacePoint UnfoldedMesh::at_vertex(Index h) const {
  return {{half_edges_.from(h), half_edges_.to(h), half_edges_.apex(h)}, {1.0, 0.0, 0.0}};
}

SurfacePoint UnfoldedMesh::on_edge(Index h, double t) const {
  if (t <= k_at_vertex) return at_vertex(h);
  if (t >= 1.0 - k_at_vertex) return at_vertex(HalfEdges::next(h));
  SurfacePoint place = at_vertex(h);
  place.shares = {1.0 - t, t, 0.0};
  return place;
}

}  // namespace planish
