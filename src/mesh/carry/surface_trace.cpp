#include "mesh/carry/surface_trace.h"

#include <algorithm>
#include <cmath>

namespace planish {

namespace {

/// How often a line that cannot be followed is halved.
constexpr int k_deepest = 10;
/// Two places so near are the same: the two sides of a seam.
constexpr double k_same_place = 1e-10;

Vec3 unit(Vec3 a) {
  const double length = norm(a);
  return length > 0.0 ? (1.0 / length) * a : Vec3{};
}

/// A point of an edge.
PlaceOnTriangle place_on(Index half_edge, double share) {
  PlaceOnTriangle place{half_edge / 3, {0.0, 0.0, 0.0}};
  place.shares[half_edge % 3] = 1.0 - share;
  place.shares[HalfEdges::next(half_edge) % 3] = share;
  place.shares = cleared(place.shares);
  return place;
}

/// The plane that a line is followed in, and how far along the line a point is.
struct Section {
  Vec3 start, across, along;

  double side(Vec3 p) const { return dot(across, p - start); }
  double way(Vec3 p) const { return dot(along, p - start); }
};

Box box_around(const TriMesh& mesh) {
  Box box;
  for (const Triangle& t : mesh.triangles) {
    for (const Index v : t)
      box.add(mesh.positions[v]);
  }
  return box;
}

}  // namespace

SurfaceTrace::SurfaceTrace(const TriMesh& mesh, double reach, double most, double step)
    : mesh_(mesh),
      half_edges_(mesh),
      nearest_(mesh),
      box_(box_around(mesh)),
      reach_(reach),
      most_(most),
      step_(step) {}

std::optional<PlaceOnTriangle> SurfaceTrace::place_of(Vec3 p) const {
  return stop_at(p).place;
}

SurfaceTrace::Stop SurfaceTrace::stop_at(Vec3 p) const {
  const ClosestPoint closest = nearest_.query(p);
  const PlaceOnTriangle place = {closest.triangle, cleared(closest.barycentric)};
  if (!(closest.squared_distance <= most_ * most_)) return {p, std::nullopt};
  // Beyond the border a point is off to the side of the mesh, else above or below it.
  const auto is_on_border = [&] {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto opposite = static_cast<Index>(3 * place.triangle + (k + 1) % 3);
      if (place.shares[k] == 0.0 && half_edges_.twin(opposite) == HalfEdges::none) return true;
      const Index corner = mesh_.triangles[place.triangle][k];
      if (place.shares[k] == 1.0 && half_edges_.is_border(corner)) return true;
    }
    return false;
  };
  if (zeros(place.shares) > 0 && is_on_border()) {
    const Vec3 apart = p - closest.point, normal = normal_at(place);
    if (norm(apart - dot(apart, normal) * normal) > reach_) return {p, std::nullopt};
  }
  return {p, place};
}

std::vector<Index> SurfaceTrace::triangles_at(const PlaceOnTriangle& place) const {
  std::vector<Index> triangles;
  const Index first = 3 * place.triangle;
  for (Index k = 0; k < 3; ++k) {
    if (place.shares[k] != 1.0) continue;
    half_edges_.for_each_corner(half_edges_.from(first + k),
                                [&](Index h) { triangles.push_back(h / 3); });
    return triangles;
  }
  triangles.push_back(place.triangle);
  for (Index k = 0; k < 3; ++k) {
    const Index twin = half_edges_.twin(HalfEdges::next(first + k));
    if (place.shares[k] == 0.0 && twin != HalfEdges::none) triangles.push_back(twin / 3);
  }
  return triangles;
}

Vec3 SurfaceTrace::normal_at(const PlaceOnTriangle& place) const {
  Vec3 sum;
  for (const Index t : triangles_at(place)) {
    const Triangle& tri = mesh_.triangles[t];
    const Vec3 a = mesh_.positions[tri[0]];
    sum += cross(mesh_.positions[tri[1]] - a, mesh_.positions[tri[2]] - a);
  }
  return unit(sum);
}

bool SurfaceTrace::are_on_one_triangle(const PlaceOnTriangle& a, const PlaceOnTriangle& b) const {
  const std::vector<Index> at_a = triangles_at(a), at_b = triangles_at(b);
  return std::find_first_of(at_a.begin(), at_a.end(), at_b.begin(), at_b.end()) != at_a.end();
}

/// The same point on a triangle of the other place: on the other side of a seam.
std::optional<PlaceOnTriangle> SurfaceTrace::moved_beside(const PlaceOnTriangle& place,
                                                          const PlaceOnTriangle& other) const {
  const Vec3 p = point_of(place, mesh_);
  for (const Index t : triangles_at(other)) {
    const Triangle& tri = mesh_.triangles[t];
    const ClosestPoint closest = closest_on_triangle(
        {mesh_.positions[tri[0]], mesh_.positions[tri[1]], mesh_.positions[tri[2]]}, p);
    if (closest.squared_distance <= k_same_place * k_same_place)
      return PlaceOnTriangle{t, cleared(closest.barycentric)};
  }
  return std::nullopt;
}

/// Walks in a plane from triangle to triangle, up to the border, the target or the end of the
/// length. A vertex in the plane counts as beside it, so that each triangle is entered and left by
/// one edge.
/// @return nothing where the section goes on beyond the target or nowhere
std::optional<SurfaceTrace::Walk> SurfaceTrace::walk(const PlaceOnTriangle& from, Vec3 normal,
                                                     Vec3 along, double length,
                                                     const PlaceOnTriangle* target) const {
  const Section section = {point_of(from, mesh_), unit(cross(along, normal)), along};
  if (section.across == Vec3{}) return std::nullopt;
  const auto side = [&](Index v) { return section.side(mesh_.positions[v]); };
  const auto is_crossed = [&](Index h) {
    return (side(half_edges_.from(h)) < 0.0) != (side(half_edges_.to(h)) < 0.0);
  };
  const auto crossing = [&](Index h) {
    const double a = side(half_edges_.from(h)), b = side(half_edges_.to(h));
    return place_on(h, a / (a - b));
  };
  const auto way_to = [&](const PlaceOnTriangle& place) {
    return section.way(point_of(place, mesh_));
  };
  std::vector<Index> aims;
  if (target != nullptr) aims = triangles_at(*target);
  std::optional<Index> exit;
  for (const Index t : triangles_at(from)) {
    for (Index h = 3 * t; h < 3 * t + 3; ++h) {
      if (is_crossed(h) && (!exit || way_to(crossing(h)) > way_to(crossing(*exit)))) exit = h;
    }
  }
  if (!exit) return std::nullopt;
  Walk walk;
  if (!(way_to(crossing(*exit)) > k_same_place)) return walk;
  for (std::size_t steps = 0; steps <= mesh_.triangles.size(); ++steps) {
    const PlaceOnTriangle place = crossing(*exit);
    const double way = way_to(place);
    const bool is_beyond = way > length;
    if (is_beyond && target == nullptr) return walk;
    if (!(way > -k_same_place)) return std::nullopt;  // around the back
    walk.places.push_back(place);
    const Index twin = half_edges_.twin(*exit);
    if (twin == HalfEdges::none)
      return is_beyond && target != nullptr ? std::nullopt : std::optional(walk);
    if (std::find(aims.begin(), aims.end(), twin / 3) != aims.end()) {
      walk.arrived = true;
      return walk;
    }
    const Index one = HalfEdges::next(twin);
    exit = is_crossed(one) ? one : HalfEdges::next(one);
  }
  return std::nullopt;
}

void SurfaceTrace::follow(Vec3 p, Vec3 q, LinePieces& pieces) const {
  Box line;
  line.add(p);
  line.add(q);
  if (are_apart(line, box_, most_)) return pieces.leave(norm(q - p));
  follow(stop_at(p), stop_at(q), 0, pieces);
}

void SurfaceTrace::follow(const Stop& a, const Stop& b, int depth, LinePieces& pieces) const {
  if (a.place && b.place) {
    follow_inside(a, b, depth, pieces);
  } else if (a.place) {
    // On the side of a seam that the line has come to.
    const PlaceOnTriangle from = pieces.is_open() ? pieces.last() : *a.place;
    const Vec3 apart = b.point - point_of(from, mesh_);
    const auto way = walk(from, normal_at(from), unit(apart), norm(apart), nullptr);
    if (!pieces.is_open()) pieces.add(from);
    Stop exit = a;
    if (way) {
      for (const PlaceOnTriangle& place : way->places)
        pieces.add(place);
      if (!way->places.empty()) exit.point = point_of(way->places.back(), mesh_);
    }
    leave({exit.point, std::nullopt}, b, depth, pieces);
  } else if (b.place) {
    const Vec3 apart = a.point - point_of(*b.place, mesh_);
    const auto way = walk(*b.place, normal_at(*b.place), unit(apart), norm(apart), nullptr);
    Stop entry = b;
    if (way && !way->places.empty()) entry.point = point_of(way->places.back(), mesh_);
    leave(a, {entry.point, std::nullopt}, depth, pieces);
    if (way) {
      for (auto place = way->places.rbegin(); place != way->places.rend(); ++place)
        pieces.add(*place);
    }
    pieces.add(*b.place);
  } else {
    leave(a, b, depth, pieces);
  }
}

/// Between two places of the mesh.
void SurfaceTrace::follow_inside(const Stop& a, const Stop& b, int depth,
                                 LinePieces& pieces) const {
  PlaceOnTriangle from = pieces.is_open() ? pieces.last() : *a.place, to = *b.place;
  if (!are_on_one_triangle(from, to)) {
    if (const auto beside = moved_beside(from, to)) {
      pieces.end();
      from = *beside;
    } else if (const auto other = moved_beside(to, from)) {
      to = *other;
    }
  }
  const auto begin = [&] {
    if (!pieces.is_open()) pieces.add(from);
  };
  if (are_on_one_triangle(from, to)) {
    begin();
    pieces.add(to);
    return;
  }
  const Vec3 start = point_of(from, mesh_), apart = point_of(to, mesh_) - start;
  const Vec3 normal = normal_at(from) + normal_at(to), along = unit(apart);
  const auto there = walk(from, normal, along, norm(apart), &to);
  if (there && there->arrived) {
    begin();
    for (const PlaceOnTriangle& place : there->places)
      pieces.add(place);
    pieces.add(to);
    return;
  }
  const auto back = there ? walk(to, normal, -along, norm(apart), &from) : std::nullopt;
  if (!back || back->arrived) return halve(a, b, depth, pieces);
  begin();
  for (const PlaceOnTriangle& place : there->places)
    pieces.add(place);
  const auto end_of = [&](const Walk& walk, const PlaceOnTriangle& other) {
    return Stop{point_of(walk.places.empty() ? other : walk.places.back(), mesh_), std::nullopt};
  };
  leave(end_of(*there, from), end_of(*back, to), depth, pieces);
  for (auto place = back->places.rbegin(); place != back->places.rend(); ++place)
    pieces.add(*place);
  pieces.add(to);
}

/// From a point off the mesh, or at its border, to another one: there may be mesh between them.
void SurfaceTrace::leave(const Stop& a, const Stop& b, int depth, LinePieces& pieces) const {
  const double length = norm(b.point - a.point);
  if (depth >= k_deepest || length <= step_) return pieces.leave(length);
  halve(a, b, depth, pieces);
}

void SurfaceTrace::halve(const Stop& a, const Stop& b, int depth, LinePieces& pieces) const {
  if (depth >= k_deepest) return pieces.leave(norm(b.point - a.point));
  const Stop middle = stop_at(0.5 * (a.point + b.point));
  follow(a, middle, depth + 1, pieces);
  follow(middle, b, depth + 1, pieces);
}

}  // namespace planish
