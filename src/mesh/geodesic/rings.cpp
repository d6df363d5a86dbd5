#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <utility>

#include <planish/mesh/cut.h>
#include <planish/mesh/geodesic.h>
#include <planish/mesh/imprint.h>

#include "core/job.h"
#include "mesh/geodesic/fronts.h"
#include "mesh/geodesic/loop_finder.h"
#include "mesh/mean_edge.h"

namespace planish {

namespace {

constexpr std::size_t k_samples = 150;  // start points of the search for rings
constexpr double k_near = 0.25;         // of its length: what is as near to a ring belongs to it
constexpr double k_wider = 0.05;        // by which the surface must be wider on both sides
constexpr double k_fewest_edges = 6.0;  // mean edges that a ring is long

double distance_to(Vec3 p, const Patch& patch, std::span<const SurfacePoint> line) {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Vec3 from = position_of(line[i - 1], patch.positions());
    const Vec3 along = position_of(line[i], patch.positions()) - from, way = p - from;
    const double length = dot(along, along);
    const double share = length > 0.0 ? std::clamp(dot(way, along) / length, 0.0, 1.0) : 0.0;
    nearest = std::min(nearest, norm(way - share * along));
  }
  return nearest;
}

/// Whether all of a line is near a ring.
bool lies_on(std::span<const SurfacePoint> line, const GeodesicPath& ring, const Patch& patch) {
  return std::all_of(line.begin(), line.end(), [&](const SurfacePoint& point) {
    return distance_to(position_of(point, patch.positions()), patch, ring.points) <=
           k_near * ring.length;
  });
}

/// Whether the surface is wider than the ring on either side of it, within half of its length.
bool is_narrow(const Patch& patch, const GeodesicPath& ring) {
  const std::vector<SurfaceLine> line = {ring.points};
  const ImprintedMesh imprinted = imprint(patch, line);
  const std::vector<CutPath> path = {{imprinted.paths.front()}};
  if (path.front().vertices.size() < 4) return false;
  const Patch whole(imprinted.mesh);
  const CutMesh cut = cut_open(whole, path);
  const Patch opened(cut.mesh);
  std::array<std::vector<Index>, 2> sides;
  for (std::size_t v = whole.vertex_count(); v < opened.vertex_count(); ++v) {
    sides[0].push_back(cut.source[v]);
    sides[1].push_back(static_cast<Index>(v));
  }
  return std::all_of(sides.begin(), sides.end(), [&](const std::vector<Index>& side) {
    const std::vector<double> distances = distances_from(opened, side);
    const std::array<double, 4> at = {0.125, 0.25, 0.375, 0.5};
    return std::any_of(at.begin(), at.end(), [&](double share) {
      return front_length(opened.mesh(), distances, share * ring.length) >=
             (1.0 + k_wider) * ring.length;
    });
  });
}

Index nearest_vertex(const SurfacePoint& place) {
  const auto largest = std::max_element(place.shares.begin(), place.shares.end());
  return place.corners[static_cast<std::size_t>(largest - place.shares.begin())];
}

}  // namespace

std::vector<GeodesicPath> narrow_rings(const Patch& patch, const Context& context) {
  require(patch.inspection(), Purpose::measure);
  const double least = k_fewest_edges * mean_edge_length(patch.mesh());
  const LoopFinder finder(patch);
  std::vector<GeodesicPath> found;
  std::vector<double> nearest(patch.vertex_count(), std::numeric_limits<double>::infinity());
  Index sample = patch.triangles().front()[0];
  for (std::size_t k = 0; k < std::min(k_samples, patch.vertex_count()); ++k) {
    stop_if_cancelled(context);
    const InsidePaths::Tree paths = finder.paths_from(sample);
    if (const auto loop = finder.shortest_loop(sample, paths)) {
      GeodesicPath ring = shortened_loop(patch, line_along_edges(patch, *loop), context);
      if (ring.length >= least) found.push_back(std::move(ring));
    }
    // The next sample is as far from all before as can be.
    for (Index v = 0; v < nearest.size(); ++v)
      nearest[v] = std::min(nearest[v], paths.distance[v]);
    for (Index v = 0; v < nearest.size(); ++v) {
      const bool is_farther = nearest[v] > nearest[sample] && !patch.ring(v).empty();
      if (is_farther) sample = v;
    }
  }
  std::stable_sort(found.begin(), found.end(), [](const GeodesicPath& a, const GeodesicPath& b) {
    return a.length < b.length;
  });
  std::vector<GeodesicPath> rings;
  std::vector<const GeodesicPath*> looked_at;
  for (GeodesicPath& ring : found) {
    const bool is_there = std::any_of(looked_at.begin(), looked_at.end(), [&](const auto* other) {
      return lies_on(ring.points, *other, patch);
    });
    if (is_there) continue;
    looked_at.push_back(&ring);
    if (is_narrow(patch, ring)) rings.push_back(ring);
  }
  return rings;
}

std::optional<GeodesicPath> ring_at(const Patch& patch, const SurfacePoint& place,
                                    const Context& context) {
  require(patch.inspection(), Purpose::measure);
  const Index v = nearest_vertex(place);
  const LoopFinder finder(patch);
  const auto loop = finder.shortest_loop(v, finder.paths_from(v));
  if (!loop) return std::nullopt;
  const SurfaceLine along = line_along_edges(patch, *loop);
  GeodesicPath ring = shortened_loop(patch, along, context);
  const double apart = distance_to(position_of(place, patch.positions()), patch, ring.points);
  if (ring.length > 0.0 && apart <= k_near * ring.length) return ring;
  return shortened(patch, along, context);
}

}  // namespace planish
