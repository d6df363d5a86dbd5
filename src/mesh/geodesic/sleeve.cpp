#include "mesh/geodesic/sleeve.h"

#include <algorithm>
#include <cstddef>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

#include "core/job.h"
#include "geometry/angle_between.h"

namespace planish {

namespace {

/// A bend of less is straight: pulling it over its vertex would save its square.
constexpr double k_straight = 1e-9;

/// Each pass makes the path shorter, but for rounding errors.
constexpr std::size_t k_most_passes = 100'000;

/// A sleeve laid into the plane. Points are the start, the ends of entered half-edges as they come,
/// and the goal.
struct UnfoldedSleeve {
  struct Portal {
    std::size_t left, right;  // points
  };
  std::vector<Vec2> points;
  std::vector<Portal> portals;  // of each entered half-edge; the last one is the goal alone
};

UnfoldedSleeve unfolded(const UnfoldedMesh& mesh, const Sleeve& sleeve, const SurfacePoint& from,
                        const SurfacePoint& to) {
  UnfoldedSleeve flat;
  const Index root =
      sleeve.entered.empty() ? 3 * sleeve.first : mesh.half_edges().twin(sleeve.entered.front());
  flat.points.push_back(mesh.in_frame(root, from));
  if (sleeve.entered.empty()) {
    flat.points.push_back(mesh.in_frame(root, to));
    flat.portals.push_back({1, 1});
    return flat;
  }
  flat.points.push_back({mesh.length(root), 0.0});
  flat.points.push_back({0.0, 0.0});
  UnfoldedSleeve::Portal portal{1, 2};
  for (std::size_t i = 0;; ++i) {
    flat.portals.push_back(portal);
    const Index h = sleeve.entered[i];
    const Vec2 origin = flat.points[portal.left], along = flat.points[portal.right] - origin;
    const Vec2 axis = (1.0 / norm(along)) * along;
    const auto place = [&](Vec2 p) { return origin + p.x * axis + p.y * Vec2{-axis.y, axis.x}; };
    const std::size_t added = flat.points.size();
    if (i + 1 == sleeve.entered.size()) {
      flat.points.push_back(place(mesh.in_frame(h, to)));
      flat.portals.push_back({added, added});
      return flat;
    }
    flat.points.push_back(place(mesh.apex(h)));
    // It is left by the side from the apex to the left or to the right.
    const Index exit = mesh.half_edges().twin(sleeve.entered[i + 1]);
    (exit == HalfEdges::next(h) ? portal.left : portal.right) = added;
  }
}

/// Where the shortest path through a sleeve bends, and the portals that end there.
struct Bend {
  std::size_t point;
  std::ptrdiff_t first, last;
};

/// The start, all bends, the goal.
std::vector<Bend> shortest_path(const UnfoldedSleeve& flat) {
  const std::vector<Vec2>& points = flat.points;
  const std::vector<UnfoldedSleeve::Portal>& portals = flat.portals;
  std::vector<Bend> path = {{0, -1, -1}};
  std::size_t apex = 0, left = 0, right = 0;
  std::size_t left_at = 0, right_at = 0;  // portals
  const auto turn = [&](std::size_t a, std::size_t b) {
    return cross(points[a] - points[apex], points[b] - points[apex]);
  };
  const auto ends_at = [&](std::size_t portal, std::size_t p) {
    return portals[portal].left == p || portals[portal].right == p;
  };
  const auto bend_at = [&](std::size_t p, std::size_t at) {
    std::size_t first = at, last = at;
    while (first > 0 && ends_at(first - 1, p))
      --first;
    while (last + 1 < portals.size() && ends_at(last + 1, p))
      ++last;
    path.push_back({p, static_cast<std::ptrdiff_t>(first), static_cast<std::ptrdiff_t>(last)});
    apex = left = right = p;
    left_at = right_at = last;
    return last;
  };
  for (std::size_t i = 0; i < portals.size(); ++i) {
    const auto [new_left, new_right] = portals[i];
    if (right == apex || turn(right, new_right) >= 0.0) {
      if (right != apex && left != apex && turn(left, new_right) > 0.0) {
        i = bend_at(left, left_at);
        continue;
      }
      right = new_right;
      right_at = i;
    }
    if (left == apex || turn(left, new_left) <= 0.0) {
      if (left != apex && right != apex && turn(right, new_left) < 0.0) {
        i = bend_at(right, right_at);
        continue;
      }
      left = new_left;
      left_at = i;
    }
  }
  const auto count = static_cast<std::ptrdiff_t>(portals.size() - 1);
  if (path.back().point != portals.back().left) path.push_back({portals.back().left, count, count});
  return path;
}

/// The vertex of a bend, and whether it is on the left of the path.
struct CaughtAt {
  Index vertex;
  bool on_left;
};

CaughtAt caught_at(const UnfoldedMesh& mesh, const Sleeve& sleeve, const UnfoldedSleeve& flat,
                   const Bend& bend) {
  const auto i = static_cast<std::size_t>(bend.first);
  const bool on_left = flat.portals[i].left == bend.point;
  const Index h = sleeve.entered[i];
  return {on_left ? mesh.half_edges().from(h) : mesh.half_edges().to(h), on_left};
}

/// The angle at a bend on the side that the sleeve is not on; infinite at the border.
double outer_angle(const UnfoldedMesh& mesh, const UnfoldedSleeve& flat, const CaughtAt& caught,
                   const Bend& before, const Bend& bend, const Bend& after) {
  if (mesh.half_edges().is_border(caught.vertex)) return 4.0 * std::numbers::pi;
  const auto arm = [&](std::size_t p) { return flat.points[p] - flat.points[bend.point]; };
  double angle = mesh.angle_around(caught.vertex);
  Vec2 last = arm(before.point);
  for (auto k = static_cast<std::size_t>(bend.first); k <= static_cast<std::size_t>(bend.last);
       ++k) {
    const Vec2 side = arm(caught.on_left ? flat.portals[k].right : flat.portals[k].left);
    angle -= angle_between(last, side);
    last = side;
  }
  return angle - angle_between(last, arm(after.point));
}

/// The half-edges entered around v from one triangle to another; nothing where the border comes
/// before.
std::optional<std::vector<Index>> way_around(const UnfoldedMesh& mesh, Index v, Index from,
                                             Index to, bool counter_clockwise) {
  const HalfEdges& half_edges = mesh.half_edges();
  std::vector<Index> entered;
  for (Index h = mesh.corner(from, v); h / 3 != to;) {
    const Index crossed = counter_clockwise ? HalfEdges::previous(h) : h;
    const Index twin = half_edges.twin(crossed);
    if (twin == HalfEdges::none) return std::nullopt;
    entered.push_back(twin);
    h = counter_clockwise ? twin : HalfEdges::next(twin);
  }
  return entered;
}

/// Leaves out the triangles in which the path would only turn around its end.
void trim(const UnfoldedMesh& mesh, Sleeve& sleeve, const SurfacePoint& from,
          const SurfacePoint& to) {
  auto& entered = sleeve.entered;
  std::size_t begin = 0, end = entered.size();
  while (begin < end && mesh.is_on_edge(entered[begin], from))
    sleeve.first = entered[begin++] / 3;
  while (begin < end && mesh.is_on_edge(entered[end - 1], to))
    --end;
  entered.erase(entered.begin() + static_cast<std::ptrdiff_t>(end), entered.end());
  entered.erase(entered.begin(), entered.begin() + static_cast<std::ptrdiff_t>(begin));
}

/// Pulls the path over the vertices that this makes it shorter at, as far as they have no
/// triangles in common. @return whether there was one
bool pull_over(const UnfoldedMesh& mesh, Sleeve& sleeve, const UnfoldedSleeve& flat,
               const std::vector<Bend>& path) {
  Sleeve pulled{sleeve.first, {}};
  std::ptrdiff_t done = -1;  // portals
  const auto copy_to = [&](std::ptrdiff_t end) {
    for (++done; done < end; ++done)
      enter(pulled, mesh.half_edges(), sleeve.entered[static_cast<std::size_t>(done)]);
  };
  bool is_changed = false;
  for (std::size_t n = 1; n + 1 < path.size(); ++n) {
    const Bend& bend = path[n];
    if (bend.first <= done) continue;
    const CaughtAt caught = caught_at(mesh, sleeve, flat, bend);
    if (outer_angle(mesh, flat, caught, path[n - 1], bend, path[n + 1]) >=
        std::numbers::pi - k_straight)
      continue;
    copy_to(bend.first);
    const Index after = sleeve.entered[static_cast<std::size_t>(bend.last)] / 3;
    const auto way = way_around(mesh, caught.vertex, pulled.last(), after, !caught.on_left);
    for (const Index h : *way)
      enter(pulled, mesh.half_edges(), h);
    done = bend.last;
    is_changed = true;
  }
  copy_to(static_cast<std::ptrdiff_t>(sleeve.entered.size()));
  sleeve = std::move(pulled);
  return is_changed;
}

GeodesicPath path_through(const UnfoldedMesh& mesh, const Sleeve& sleeve,
                          const UnfoldedSleeve& flat, const std::vector<Bend>& bends,
                          const SurfacePoint& from, const SurfacePoint& to) {
  GeodesicPath path;
  path.points.push_back(from);
  const auto add = [&](const SurfacePoint& place) {
    const Index v = UnfoldedMesh::vertex_of(place);
    if (v == HalfEdges::none || v != UnfoldedMesh::vertex_of(path.points.back()))
      path.points.push_back(place);
  };
  for (std::size_t n = 1; n < bends.size(); ++n) {
    const Vec2 a = flat.points[bends[n - 1].point], b = flat.points[bends[n].point];
    path.length += norm(b - a) / mesh.scale();
    for (auto k = bends[n - 1].last + 1; k < bends[n].first; ++k) {
      const auto [left, right] = flat.portals[static_cast<std::size_t>(k)];
      const double to_left = cross(b - a, flat.points[left] - a);
      const double to_right = cross(b - a, flat.points[right] - a);
      const double t = to_left == to_right ? 0.0 : to_left / (to_left - to_right);
      add(mesh.on_edge(sleeve.entered[static_cast<std::size_t>(k)], std::clamp(t, 0.0, 1.0)));
    }
    if (n + 1 == bends.size()) break;
    const Index h = sleeve.entered[static_cast<std::size_t>(bends[n].first)];
    add(mesh.at_vertex(caught_at(mesh, sleeve, flat, bends[n]).on_left ? h : HalfEdges::next(h)));
  }
  const Index end = UnfoldedMesh::vertex_of(to);
  if (path.points.size() > 1 && end != HalfEdges::none &&
      end == UnfoldedMesh::vertex_of(path.points.back()))
    path.points.pop_back();
  path.points.push_back(to);
  return path;
}

}  // namespace

void enter(Sleeve& sleeve, const HalfEdges& half_edges, Index h) {
  if (!sleeve.entered.empty() && sleeve.entered.back() == half_edges.twin(h)) {
    sleeve.entered.pop_back();
  } else {
    sleeve.entered.push_back(h);
  }
}

void turn_around(Sleeve& sleeve, const UnfoldedMesh& mesh, Index v, Index triangle) {
  const auto left = way_around(mesh, v, sleeve.last(), triangle, true);
  const auto right = way_around(mesh, v, sleeve.last(), triangle, false);
  for (const Index h : left && (!right || left->size() <= right->size()) ? *left : *right)
    enter(sleeve, mesh.half_edges(), h);
}

Sleeve sleeve_of(const UnfoldedMesh& mesh, std::span<const SurfacePoint> path) {
  Sleeve sleeve;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const SurfacePoint& at = path[i - 1];
    std::vector<Index> shared = mesh.triangles_at(at);
    std::erase_if(shared, [&](Index t) { return !mesh.is_on(t, path[i]); });
    if (shared.empty()) {
      throw Error(ErrorCode::option_out_of_range,
                  "places " + std::to_string(i - 1) + " and " + std::to_string(i) +
                      " of the path, counted from 0, are on no common triangle: add one on each "
                      "edge that the path crosses");
    }
    if (i == 1) sleeve.first = shared.front();
    if (std::find(shared.begin(), shared.end(), sleeve.last()) != shared.end()) continue;
    // Both triangles have the place: around its vertex, which on an edge is either end.
    const auto k = static_cast<std::size_t>(std::max_element(at.shares.begin(), at.shares.end()) -
                                            at.shares.begin());
    turn_around(sleeve, mesh, at.corners[k], shared.front());
  }
  return sleeve;
}

GeodesicPath drawn_tight(const UnfoldedMesh& mesh, Sleeve sleeve, const SurfacePoint& from,
                         const SurfacePoint& to, const Context& context) {
  for (std::size_t pass = 0;; ++pass) {
    stop_if_cancelled(context);
    trim(mesh, sleeve, from, to);
    const UnfoldedSleeve flat = unfolded(mesh, sleeve, from, to);
    const std::vector<Bend> bends = shortest_path(flat);
    Sleeve pulled = sleeve;
    if (!pull_over(mesh, pulled, flat, bends) || pass == k_most_passes)
      return path_through(mesh, sleeve, flat, bends, from, to);
    sleeve = std::move(pulled);
  }
}

}  // namespace planish
