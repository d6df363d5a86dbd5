#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

#include <planish/mesh/geodesic.h>

#include "mesh/cut/edge_paths.h"
#include "mesh/geodesic/sleeve.h"
#include "mesh/geodesic/unfolded_mesh.h"
#include "mesh/geodesic/window_search.h"

namespace planish {

namespace {

/// A loop is done when two rounds make it shorter by no more than this together, relative.
constexpr double k_settled = 1e-14;
constexpr double k_same_place = 1e-12;  // in sizes of the mesh
constexpr int k_most_rounds = 10'000;

std::vector<SurfacePoint> checked(const UnfoldedMesh& mesh, std::span<const SurfacePoint> path) {
  if (path.size() < 2) {
    throw Error(ErrorCode::option_out_of_range,
                "a path has fewer than two places: give its ends at least");
  }
  std::vector<SurfacePoint> places;
  places.reserve(path.size());
  for (const SurfacePoint& place : path)
    places.push_back(mesh.checked(place));
  return places;
}

double length_of(const UnfoldedMesh& mesh, std::span<const SurfacePoint> path) {
  double length = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i)
    length += norm(mesh.position(path[i]) - mesh.position(path[i - 1]));
  return length / mesh.scale();
}

/// A corner that has a share of the place.
Index vertex_near(const SurfacePoint& place) {
  const auto largest = std::max_element(place.shares.begin(), place.shares.end());
  return place.corners[static_cast<std::size_t>(largest - place.shares.begin())];
}

/// A path along edges between two places.
std::vector<SurfacePoint> path_along_edges(const Patch& patch, const UnfoldedMesh& mesh,
                                           const SurfacePoint& from, const SurfacePoint& to) {
  const auto vertices = EdgePaths(patch).between(vertex_near(from), vertex_near(to));
  if (!vertices) {
    throw Error(ErrorCode::several_components,
                "no path leads from one place to the other: they are on separate parts of the "
                "mesh; take places on one part, or join the parts (--weld)");
  }
  std::vector<SurfacePoint> path = {from};
  for (const Index v : *vertices)
    path.push_back(mesh.at_vertex(mesh.half_edges().first(v)));
  path.push_back(to);
  return path;
}

/// The loop from another of its places on, half of its length away from where it begins.
std::vector<SurfacePoint> from_its_middle(const UnfoldedMesh& mesh, const GeodesicPath& loop) {
  const auto& points = loop.points;
  double length = 0.0;
  std::size_t middle = 0;
  while (middle + 2 < points.size() && length < 0.5 * loop.length) {
    ++middle;
    length += length_of(mesh, std::span(points).subspan(middle - 1, 2));
  }
  const auto at = points.begin() + static_cast<std::ptrdiff_t>(middle);
  std::vector<SurfacePoint> moved(at, points.end());
  moved.insert(moved.end(), points.begin() + 1, at + 1);
  return moved;
}

}  // namespace

GeodesicPath geodesic(const Patch& patch, const SurfacePoint& from, const SurfacePoint& to,
                      const Context& context) {
  const UnfoldedMesh mesh(patch);
  const SurfacePoint start = mesh.checked(from), goal = mesh.checked(to);
  const std::vector<Index> around = mesh.triangles_at(start);
  GeodesicPath path{{from, to}, length_of(mesh, std::vector{start, goal})};
  if (std::any_of(around.begin(), around.end(), [&](Index t) { return mesh.is_on(t, goal); }))
    return path;
  const auto tight = [&](Sleeve sleeve) {
    return drawn_tight(mesh, std::move(sleeve), start, goal, context);
  };
  const Sleeve along_edges = sleeve_of(mesh, path_along_edges(patch, mesh, start, goal));
  GeodesicPath known = tight(along_edges);
  WindowSearch search(mesh, start, goal, known.length * mesh.scale());
  path = tight(search.run(along_edges, context));
  if (known.length <= path.length) path = std::move(known);
  path.points.front() = from;
  path.points.back() = to;
  return path;
}

GeodesicPath shortened(const Patch& patch, std::span<const SurfacePoint> path,
                       const Context& context) {
  const UnfoldedMesh mesh(patch);
  const std::vector<SurfacePoint> places = checked(mesh, path);
  GeodesicPath tight =
      drawn_tight(mesh, sleeve_of(mesh, places), places.front(), places.back(), context);
  tight.points.front() = path.front();
  tight.points.back() = path.back();
  return tight;
}

GeodesicPath shortened_loop(const Patch& patch, std::span<const SurfacePoint> loop,
                            const Context& context) {
  const UnfoldedMesh mesh(patch);
  std::vector<SurfacePoint> places = checked(mesh, loop);
  if (!(norm(mesh.position(places.back()) - mesh.position(places.front())) <= k_same_place)) {
    throw Error(
        ErrorCode::option_out_of_range,
        "a loop ends in another place than it begins in: repeat its first place at its end");
  }
  places.back() = places.front();
  // Birkhoff: in turn with one place held and with another one held.
  GeodesicPath tight{places, length_of(mesh, places)};
  double before_last = 2.0 * tight.length;
  for (int round = 0; round < k_most_rounds; ++round) {
    GeodesicPath next =
        drawn_tight(mesh, sleeve_of(mesh, places), places.front(), places.front(), context);
    const double last = std::exchange(before_last, tight.length);
    tight = std::move(next);
    if (tight.length >= (1.0 - k_settled) * last) break;
    places = from_its_middle(mesh, tight);
  }
  return tight;
}

}  // namespace planish
